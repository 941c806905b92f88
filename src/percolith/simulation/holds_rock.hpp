// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/setup.hpp"

#include <optional>

namespace percolith::simulation {

/// Whether a condition keeps rock that is under stress from springing apart. Edges that only absorb
/// waves give way, and a load of zero at all times is none.
[[nodiscard]] inline bool holds_rock(const BoundaryCondition& condition) {
  const auto pushes = [](const std::optional<Schedule>& load) {
    return load && load->largest() != 0.0;
  };
  return condition.fixed || condition.roller || condition.in_situ || condition.displacement_x ||
         condition.displacement_y || condition.velocity_x || condition.velocity_y ||
         pushes(condition.traction_x) || pushes(condition.traction_y) ||
         pushes(condition.normal_pressure) ||
         (condition.pressurised && (pushes(condition.pressure) || pushes(condition.head)));
}

}  // namespace percolith::simulation
