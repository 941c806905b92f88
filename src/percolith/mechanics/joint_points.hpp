// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/joint.hpp"
#include "percolith/mechanics/joint_forces.hpp"

namespace percolith::mechanics {

/// The state of a joint at its two integration points, for what looks at single joints.
struct JointPoints {
  JointPlace<double> place;
  std::array<double, 2> opening{}, slip{};                    ///< m, in-situ start included
  std::array<material::JointTraction<double>, 2> traction{};  ///< Pa; of the bond, 0 without one
  std::array<material::JointMoment<double>, 2> moment{};      ///< the same with its parts
};

/// Constants of the law of a joint, its stiffness and the scatter of its strengths included.
[[nodiscard]] material::JointConstants<double>
joint_constants(const Model& model, const JointTable& table, Index joint);

/// Opening and slip of any joint, and the traction of its bond with the memory as it stands.
/// `back` (s): where the corners were so long ago, at their present velocities.
[[nodiscard]] JointPoints joint_points(const Model& model, const JointTable& table, Index joint,
                                       double back = 0.0);

/// What a bond that softens lost from the last `JointForces` to the places of `back`, J/m.
[[nodiscard]] material::JointLoss<double>
bond_loss_since(const Model& model, const JointTable& table, Index joint, double back);

/// Books `bond_loss_since` the last step to the present places: the joint is about to be given up.
void book_bond(Model& model, const JointTable& table, Index joint);

/// Opening and slip alone.
[[nodiscard]] JointPoints joint_openings(const Model& model, Index joint, double back = 0.0);

}  // namespace percolith::mechanics
