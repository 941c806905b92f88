// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/joint_forces.hpp"

namespace percolith::mechanics {

JointForces::JointForces(Model& model, const JointTable& table)
    : reader_(model, table, model.motion.ux.data(), model.motion.uy.data()),
      opening_peak_{model.joints.opening_peak[0].data(), model.joints.opening_peak[1].data()},
      slip_peak_{model.joints.slip_peak[0].data(), model.joints.slip_peak[1].data()},
      damage_{model.joints.damage[0].data(), model.joints.damage[1].data()},
      past_opening_{model.joints.past.opening[0].data(), model.joints.past.opening[1].data()},
      past_slip_{model.joints.past.slip[0].data(), model.joints.past.slip[1].data()},
      past_normal_{model.joints.past.normal[0].data(), model.joints.past.normal[1].data()},
      past_shear_{model.joints.past.shear[0].data(), model.joints.past.shear[1].data()},
      past_slope_{model.joints.past.slope[0].data(), model.joints.past.slope[1].data()},
      past_friction_{model.joints.past.friction[0].data(), model.joints.past.friction[1].data()},
      spent_(model.joints.past.spent.data()), rubbed_(model.joints.past.rubbed.data()),
      condition_(model.joints.condition.data()), force_(model.joints.force.data()) {}

}  // namespace percolith::mechanics
