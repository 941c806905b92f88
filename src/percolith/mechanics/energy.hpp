// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/execution.hpp"
#include "percolith/mechanics/stored_energy.hpp"

namespace percolith::mechanics {

/// Energy of one triangle strained from its in-situ stress, J/m, in the present places.
[[nodiscard]] double elastic_energy_of(const Model& model, Index triangle);

/// Energy of the rock strained from its in-situ stress at the displacements `u`, J/m: sum of
/// A (E.D.E/2 + S_0.E).
[[nodiscard]] double elastic_energy(const Model& model, const Displacements& u,
                                    Execution& execution);

/// Of the bonded joints, J/m.
struct JointEnergy {
  double stored = 0.0;  ///< given back along their secants; in-situ stress counts from the start
  double fluid = 0.0;   ///< work of the pore pressure in them since the last step
};

/// What bonded joints hold at the displacements `u`, with their memory as it stands.
[[nodiscard]] JointEnergy energy_in_joints(const Model& model, const JointTable& table,
                                           const Displacements& u, Execution& execution);

/// Energy that bonded joints would give back along their secants and closed ones from their
/// springs, J/m, in the present places.
[[nodiscard]] double stored_in_joints(const Model& model, const JointTable& table,
                                      Execution& execution);

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

/// The balance of a model that started with `start`; contact counts as it is given. `u`: where the
/// corners were in the middle of the last step.
[[nodiscard]] EnergyBalance energy_balance(const Model& model, const JointTable& table,
                                           const EnergyStart& start, const ContactEnergy& contact,
                                           const Displacements& u, Execution& execution);

}  // namespace percolith::mechanics
