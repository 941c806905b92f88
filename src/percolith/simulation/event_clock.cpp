// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/event_clock.hpp"

#include <algorithm>
#include <cmath>

namespace percolith::simulation {

EventClock::EventClock(const Output& output, double end) : times_{end} {
  for (const double t : output.times) {
    if (t > 0.0 && t < end) {
      times_.push_back(t);
    }
  }
  if (output.interval) {
    // The last multiple may differ from the end by round-off only.
    for (double n = 1.0; n * *output.interval < end * (1.0 - 1e-12); n += 1.0) {
      times_.push_back(n * *output.interval);
    }
  }
  std::sort(times_.begin(), times_.end());
  // A time from the list and a multiple of the interval may differ by round-off: they are one.
  const auto coincide = [end](double a, double b) { return b - a < 1e-12 * end; };
  times_.erase(std::unique(times_.begin(), times_.end(), coincide), times_.end());
  times_.back() = end;
}

double EventClock::next_output(double t) const {
  const auto next = std::upper_bound(times_.begin(), times_.end(), t);
  return next == times_.end() ? std::numeric_limits<double>::infinity() : *next;
}

bool HistoryClock::due(double t) {
  if (t < next_) {
    return false;
  }
  next_ = interval_ > 0.0 ? interval_ * (std::floor(t / interval_ * (1.0 + 1e-12)) + 1.0) : t;
  return true;
}

}  // namespace percolith::simulation
