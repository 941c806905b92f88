// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/joint_forces.hpp"

namespace percolith::mechanics {

JointTable joint_table(const Model& model) {
  JointTable table;
  table.reserve(model.kind.size());
  for (const JointKind& kind : model.kind) {
    const material::JointStrength& s = kind.strength;
    table.push_back({0.0, s.tensile_strength, s.cohesion, kind.friction,
                     material::softening_integral * s.tensile_strength / s.mode_1_energy,
                     material::softening_integral * s.cohesion / s.mode_2_energy});
  }
  return table;
}

JointForces::JointForces(Model& model, const JointTable& constants_of_kinds)
    : ux(model.motion.ux.data()), uy(model.motion.uy.data()), slot(model.joints.slot.data()),
      ex(model.joints.ex.data()), ey(model.joints.ey.data()),
      stiffness(model.joints.stiffness.data()), strength(model.joints.strength.data()),
      uniform(model.joints.uniform.data()), table(constants_of_kinds.data()),
      factor(model.joints.factor.empty() ? nullptr : model.joints.factor.data()),
      starts(!model.joints.opening_start[0].empty()),
      opening_start{model.joints.opening_start[0].data(), model.joints.opening_start[1].data()},
      slip_start{model.joints.slip_start[0].data(), model.joints.slip_start[1].data()},
      opening_peak{model.joints.opening_peak[0].data(), model.joints.opening_peak[1].data()},
      slip_peak{model.joints.slip_peak[0].data(), model.joints.slip_peak[1].data()},
      damage{model.joints.damage[0].data(), model.joints.damage[1].data()},
      condition(model.joints.condition.data()), force(model.joints.force.data()) {}

}  // namespace percolith::mechanics
