// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/account.hpp"

#include <algorithm>

namespace percolith::seepage {
namespace {

/// Calls `visit(condition, amount)` with the net amount of each run of bookings at one vertex.
template <class Visit>
void for_each_vertex(std::span<const Booking> bookings, const Visit& visit) {
  for (std::size_t i = 0; i < bookings.size();) {
    const Booking& first = bookings[i];
    double net = 0.0;
    for (; i < bookings.size() && bookings[i].condition == first.condition &&
           bookings[i].vertex == first.vertex;
         ++i) {
      net += bookings[i].amount;
    }
    visit(static_cast<std::size_t>(first.condition), net);
  }
}

void add_rate(Model& model, std::size_t condition, double rate) {
  model.rate[condition] += rate;
  (rate >= 0.0 ? model.rate_in : model.rate_out) += std::max(rate, -rate);
}

void begin(Model& model) {
  std::fill(model.rate.begin(), model.rate.end(), 0.0);
  model.rate_in = 0.0;
  model.rate_out = 0.0;
}

}  // namespace

void book_step(Model& model, std::span<const Booking> bookings, double dt) {
  begin(model);
  for_each_vertex(bookings, [&](std::size_t condition, double volume) {
    model.let_in[condition] += volume;
    (volume >= 0.0 ? model.passed_in : model.passed_out) += std::max(volume, -volume);
    add_rate(model, condition, volume / dt);
  });
}

void book_steady(Model& model, std::span<const Booking> bookings) {
  begin(model);
  for_each_vertex(bookings,
                  [&](std::size_t condition, double rate) { add_rate(model, condition, rate); });
}

}  // namespace percolith::seepage
