// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/joint_reader.hpp"

namespace percolith::mechanics {

namespace {

/// Reciprocal of a range of softening (1/m) of a strength that spends `energy` (J/m2). Without
/// strength there is nothing to soften: the range is next to nothing.
double inverse_range(double strength, double energy) {
  constexpr double at_once = 1e30;
  return strength > 0.0 ? material::softening_integral * strength / energy : at_once;
}

}  // namespace

JointTable joint_table(const Model& model) {
  JointTable table;
  table.reserve(model.kind.size());
  for (const JointKind& kind : model.kind) {
    const material::JointStrength& s = kind.strength;
    table.push_back({0.0, s.tensile_strength, s.cohesion, kind.friction,
                     inverse_range(s.tensile_strength, s.mode_1_energy),
                     inverse_range(s.cohesion, s.mode_2_energy)});
  }
  return table;
}

JointReader::JointReader(const Model& model, const JointTable& table, const double* ux,
                         const double* uy)
    : ux_(ux), uy_(uy), slot_(model.joints.slot.data()), ex_(model.joints.ex.data()),
      ey_(model.joints.ey.data()), length_(model.joints.length.data()),
      stiffness_(model.joints.stiffness.data()), strength_(model.joints.strength.data()),
      uniform_(model.joints.uniform.data()), table_(table.data()),
      factor_(model.joints.factor.empty() ? nullptr : model.joints.factor.data()),
      starts_(!model.joints.opening_start[0].empty()),
      opening_start_{model.joints.opening_start[0].data(), model.joints.opening_start[1].data()},
      slip_start_{model.joints.slip_start[0].data(), model.joints.slip_start[1].data()},
      opening_peak_{model.joints.opening_peak[0].data(), model.joints.opening_peak[1].data()},
      slip_peak_{model.joints.slip_peak[0].data(), model.joints.slip_peak[1].data()},
      damage_{model.joints.damage[0].data(), model.joints.damage[1].data()},
      past_slope_{model.joints.past.slope[0].data(), model.joints.past.slope[1].data()},
      past_friction_{model.joints.past.friction[0].data(), model.joints.past.friction[1].data()},
      past_slip_{model.joints.past.slip[0].data(), model.joints.past.slip[1].data()} {}

}  // namespace percolith::mechanics
