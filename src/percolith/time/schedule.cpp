// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/time/schedule.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace percolith {

Schedule Schedule::constant(double value) {
  return Schedule{{0.0}, {value}, Interpolation::linear};
}

double Schedule::at(double t) const {
  const auto after = std::upper_bound(time.begin(), time.end(), t);
  if (after == time.begin()) {
    return value.front();
  }
  const auto last = static_cast<std::size_t>(after - time.begin()) - 1;
  if (after == time.end() || interpolation == Interpolation::step) {
    return value[last];
  }
  const double fraction = (t - time[last]) / (time[last + 1] - time[last]);
  return value[last] + fraction * (value[last + 1] - value[last]);
}

double Schedule::next_break(double t) const {
  const auto after = std::upper_bound(time.begin(), time.end(), t);
  if (is_constant() || after == time.end()) {
    return std::numeric_limits<double>::infinity();
  }
  return *after;
}

double Schedule::largest() const {
  return *std::max_element(value.begin(), value.end(),
                           [](double a, double b) { return std::abs(a) < std::abs(b); });
}

void describe_state(StateArchive& archive, Schedule& schedule) {
  archive.of_any_size("time", schedule.time);
  archive.of_any_size("value", schedule.value);
  archive("interpolation", schedule.interpolation);
}

}  // namespace percolith
