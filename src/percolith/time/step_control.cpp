// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/time/step_control.hpp"

#include <algorithm>
#include <cmath>

namespace percolith {

bool StepControl::judge(double dt, double error) {
  constexpr double margin = 0.9;
  constexpr double smallest_factor = 0.1;
  const double factor = error > 0.0 ? margin * std::sqrt(tolerance_ / error) : 2.0;
  // A step may exceed the smallest by round-off on its way to an event.
  if (error > tolerance_ && dt > smallest_ * (1.0 + 1e-6)) {
    step_ = std::max(dt * std::max(factor, smallest_factor), smallest_);
    return false;
  }
  if (factor >= 2.0) {
    // A step cut short by an event must not shrink the steps after it.
    step_ = std::min(std::max(2.0 * dt, step_), largest_);
  }
  return true;
}

double step_towards(double time, double event, double step) {
  const double rest = event - time;
  if (rest <= step * (1.0 + 1e-9)) {
    return rest;
  }
  return rest < 2.0 * step ? 0.5 * rest : step;
}

}  // namespace percolith
