// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/execution.hpp"
#include "percolith/mechanics/joint_forces.hpp"
#include "percolith/mechanics/model.hpp"

namespace percolith::mechanics {

/// Energy of one triangle strained from its in-situ stress, J/m; `back` as in `triangle_strain`.
[[nodiscard]] double elastic_energy_of(const Model& model, Index triangle, double back = 0.0);

/// Energy of the rock strained from its in-situ stress, J/m: sum of A (E.D.E/2 + S_0.E).
/// `back` (s): where the corners were so long ago, at their present velocities.
[[nodiscard]] double elastic_energy(const Model& model, const Execution& execution,
                                    double back = 0.0);

/// Energy that bonded joints would give back along their secants and closed ones from their
/// springs, J/m; in-situ stress counts from the start. `back` as for `elastic_energy`.
[[nodiscard]] double stored_in_joints(const Model& model, const JointTable& table,
                                      const Execution& execution, double back = 0.0);

/// Energy balance from time zero to the middle of the last step, J/m, where the velocities are.
/// Kinetic energy and the works from outside are those of the discrete motion. What is stored in
/// triangles, joints and contacts is a function of the positions half a step ago, and what joints
/// and friction spend follows from their laws, point by point: `residual` shows the error of the
/// integration in time and whatever the laws do not account for, as a jump where contact takes over
/// from a joint.
struct EnergyBalance {
  double kinetic = 0.0, elastic = 0.0;  ///< now
  double joint = 0.0;                   ///< stored in bonded and closed joints, since the start
  double fracture = 0.0;                ///< spent in bonds past their peak, friction not included
  double contact = 0.0;                 ///< stored in contact
  double friction = 0.0;                ///< spent by sliding faces, bonded or not
  double damping = 0.0;                 ///< spent by damping, element viscosity included
  double absorbed = 0.0;  ///< left through absorbing boundaries or with rock taken out
  double gravity = 0.0, external = 0.0;  ///< work done on the rock
  double fluid = 0.0;                    ///< work of fluid in pores and cracks on the rock
  double residual = 0.0;                 ///< what the terms do not account for
};

/// What the state was worth at time zero.
struct EnergyStart {
  double kinetic = 0.0, elastic = 0.0, joint = 0.0;
};

/// Of contact, J/m: stored, and spent by friction since the start. What the tangential springs
/// store and what friction spends is that of the last evaluation, half a step earlier.
struct ContactEnergy {
  double stored = 0.0, friction = 0.0;
};

/// The balance of a model that started with `start`; contact counts as it is given.
[[nodiscard]] EnergyBalance energy_balance(const Model& model, const JointTable& table,
                                           const EnergyStart& start, const ContactEnergy& contact,
                                           const Execution& execution);

}  // namespace percolith::mechanics
