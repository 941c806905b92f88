// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/execution.hpp"
#include "percolith/mechanics/model.hpp"

#include <array>
#include <functional>
#include <span>

namespace percolith::mechanics {

/// Lets fluid press the faces of further joints, with no pressure at first.
void add_pressed(Model& model, std::span<const Index> joints);

/// Measures opening (m) and direction of all joints that fluid presses, in the present places: what
/// side 1 has moved away from side 0 at both ends across the joint, negative where faces overlap.
/// In-situ stress does not count. And the stress (Pa) with which faces press on each other, in-situ
/// stress included as long as they have not parted, by the stiffness of the joint.
void measure_faces(Model& model, Execution& execution);

/// Adds the forces of the fluid to those of the joints, p L/2 at each end of each face (37), and
/// books their work since the last step. The pressures are those of the present places, which have
/// been measured.
void press_faces(Model& model, Execution& execution);

/// Force (N/m) of the fluid between the faces of a joint on side 0 at both ends, in the present
/// place; none where no fluid presses it.
[[nodiscard]] std::array<Point, 2> force_of_fluid(const Model& model, Index joint);

/// Lets fluid press joints no longer that have been taken out or given up, `gone(joint)`.
void forget_pressed(Model& model, const std::function<bool(Index)>& gone);

/// Work of the present pressures from the places measured last to those of `back` (s), as
/// `joint_points` takes it, J/m.
[[nodiscard]] double work_on_faces_since(const Model& model, double back);

/// Books the work of the last pressures up to the openings measured last: the next ones act from
/// there on.
void book_faces(Model& model);

}  // namespace percolith::mechanics
