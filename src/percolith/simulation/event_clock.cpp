// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/event_clock.hpp"

#include "percolith/core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace percolith::simulation {
namespace {

/// Times closer to each other than this share of the run are one.
constexpr double coincidence = 1e-12;
constexpr double most_outputs = 1e6;

void require_rows(const char* key, const std::optional<double>& interval, double end) {
  if (interval && end / *interval > most_outputs) {
    throw InputError(
        {{},
         key,
         fmt::format("{:g} s", *interval),
         fmt::format("{:.3g} intervals fit into the {:g} s of the run", end / *interval, end),
         fmt::format("at most {:g}, an interval of at least {:g} s", most_outputs,
                     end / most_outputs)});
  }
}

}  // namespace

void require_sensible_intervals(const Setup& setup) {
  if (setup.time.scheme != Scheme::steady) {
    require_rows("output.interval", setup.output.interval, setup.time.end);
    require_rows("output.history_interval", setup.output.history_interval, setup.time.end);
    require_rows("output.checkpoint_interval", setup.output.checkpoint_interval, setup.time.end);
  }
}

EventClock::EventClock(const Output& output, double end)
    : times_{end}, interval_(output.interval.value_or(0.0)) {
  for (const double t : output.times) {
    if (t > 0.0 && t < end) {
      times_.push_back(t);
    }
  }
  std::sort(times_.begin(), times_.end());
  const auto coincide = [end](double a, double b) { return b - a < coincidence * end; };
  times_.erase(std::unique(times_.begin(), times_.end(), coincide), times_.end());
  times_.back() = end;
}

double EventClock::next_output(double t) const {
  const auto listed = std::upper_bound(times_.begin(), times_.end(), t);
  if (listed == times_.end()) {
    return std::numeric_limits<double>::infinity();
  }
  if (interval_ > 0.0) {
    const double tolerance = coincidence * times_.back();
    const double multiple = (std::floor((t + tolerance) / interval_) + 1.0) * interval_;
    // A time from the list and a multiple of the interval may differ by round-off: they are one.
    if (multiple > t + tolerance && multiple < *listed - tolerance) {
      return multiple;
    }
  }
  return *listed;
}

bool EventClock::reaches(double t, double output) const {
  return t >= output - coincidence * times_.back();
}

bool HistoryClock::due(double t) {
  if (t < next_) {
    return false;
  }
  next_ = interval_ > 0.0 ? interval_ * (std::floor(t / interval_ * (1.0 + 1e-12)) + 1.0) : t;
  return true;
}

}  // namespace percolith::simulation
