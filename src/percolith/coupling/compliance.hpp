// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/coupling/coupled_model.hpp"

#include <vector>

// How the rock gives way under the pressure of a fluid: estimates that make the iteration between
// flow and motion converge. Of themselves they do not change what it converges to; how much of the
// way is left after a change has to be judged by them (see `Approach`), and what breaks on the way
// stays broken (see `PressureRise`).
namespace percolith::coupling {

/// Per corner: growth of its pores per pressure in a rock that is free to give way,
/// alpha^2 V/(lambda + G), m2/Pa.
[[nodiscard]] std::vector<double> pore_compliance(const CoupledModel& model);

/// Per vertex: growth of the room of its crack node per pressure, m2/Pa. Open faces of a crack that
/// hangs together over a length c give way like those of a straight crack of that length in a large
/// body, by about 3 c/E' at its middle; faces that press on each other by the stiffness of their
/// joint.
[[nodiscard]] std::vector<double> crack_compliance(const CoupledModel& model);

/// Pressures of all corners, then of all vertices, Pa.
[[nodiscard]] std::vector<double> pressures_of(const seepage::Model& water);

}  // namespace percolith::coupling
