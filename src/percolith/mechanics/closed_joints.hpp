// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/execution.hpp"
#include "percolith/material/joint_law.hpp"
#include "percolith/mechanics/contact/contact.hpp"
#include "percolith/mechanics/model.hpp"

#include <vector>

namespace percolith::mechanics {

/// Forces of the closed joints in the present positions: k times the overlap of the faces and
/// Coulomb friction with a plastic slip. Overwrites the forces the bonded joints left there (none),
/// books the energy friction spends.
void add_closed_joints(Model& model, Execution& execution);

/// Adds to the forces of contact those that go with the turns of the closed joints: the tractions
/// of faces that have slid past each other have a moment, which these balance.
void add_turns(const Model& model, Contact& contact);

/// What a closed joint carries, and whether it goes on to be closed.
struct ClosedJointEnd {
  Index joint = 0;
  double normal_force = 0.0;  ///< N/m, compression positive
  Point shear_on_first;       ///< N/m, on side 0
  double stiffness = 0.0;     ///< k, Pa/m
  double friction = 0.0;      ///< spent since the last `add_closed_joints`, J/m
};

/// The closed joints that were found in the last `add_closed_joints` to have ended: their faces
/// have parted, or slid so far (a tenth of their length) that they no longer face each other;
/// ascending.
[[nodiscard]] std::vector<ClosedJointEnd> ended_closed_joints(const Model& model);

/// Energy the closed joints would give back, J/m; `back` as in `joint_points`.
[[nodiscard]] double stored_in_closed_joints(const Model& model, double back = 0.0);

/// Tractions of a closed joint at the present places, Pa, [point].
[[nodiscard]] std::array<material::JointTraction<double>, 2>
closed_tractions(const Model& model, const ClosedJoint& closed);

/// What friction of closed joints spends from the last `add_closed_joints` to the places of
/// `back`, J/m.
[[nodiscard]] double closed_friction_since(const Model& model, double back);

}  // namespace percolith::mechanics
