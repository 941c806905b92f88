// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace percolith::material {

/// Strength and fracture energy of the joints of a rock or of a fracture group.
struct JointStrength {
  double tensile_strength = 0.0;  ///< f_t, Pa
  double cohesion = 0.0;          ///< c, Pa
  /// phi, rad: of unbroken joints; absent in a fracture: that of the rock.
  std::optional<double> friction_angle;
  /// rad: of broken joints and of contact; absent: friction_angle.
  std::optional<double> residual_friction_angle;
  double mode_1_energy = 0.0;  ///< G_I, J/m2
  double mode_2_energy = 0.0;  ///< G_II, J/m2
  /// p_f, Pa: stiffness of a joint is p_f/h, h the element size; absent: 20 E of the softer side.
  std::optional<double> joint_penalty;
  friend bool operator==(const JointStrength&, const JointStrength&) = default;
};

}  // namespace percolith::material
