// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/coupling/approach.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace percolith::coupling {
namespace {

/// The part of `now` along `before`, over `before`, from `first` on.
double ratio_of(const std::vector<double>& now, const std::vector<double>& before,
                std::size_t first) {
  double product = 0.0;
  double square = 0.0;
  for (std::size_t i = first < now.size() ? first : 0; i < now.size(); ++i) {
    product += now[i] * before[i];
    square += before[i] * before[i];
  }
  return square > 0.0 ? product / square : 0.0;
}

}  // namespace

void Approach::see(const std::vector<double>& before, const std::vector<double>& now,
                   std::size_t first, double softness) {
  std::vector<double> step(now.size());
  double largest = 1e-300;
  double change = 0.0;
  for (std::size_t i = 0; i < now.size(); ++i) {
    step[i] = now[i] - before[i];
    change = std::max(change, std::abs(step[i]));
    largest = std::max(largest, std::abs(now[i]));
  }
  change_ = change / largest;
  found_.reset();
  if (last_.size() == step.size()) {
    found_ = used_ - softness * ratio_of(step, last_, first);
  }
  last_ = std::move(step);
  used_ = softness;
}

double Approach::distance() const {
  constexpr double slowest = 0.01;
  const double share = found_.value_or(used_) / used_;
  return change_ / std::clamp(share, slowest, 1.0);
}

}  // namespace percolith::coupling
