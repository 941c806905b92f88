// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/wet_joints.hpp"

#include "percolith/mechanics/joint_points.hpp"

namespace percolith::mechanics {

WetJointForces::WetJointForces(Model& model, const JointTable& table)
    : joints_(model, table), pores_{
                                 model.pores.pressure.data(),
                                 model.pores.joint_share.data(),
                                 model.joints.slot.data(),
                                 {model.pores.push[0].data(), model.pores.push[1].data()},
                                 {model.pores.opening[0].data(), model.pores.opening[1].data()}} {}

std::array<double, 2> push_in_joint(const Model& model, Index joint) {
  if (model.pores.joint_share.empty()) {
    return {};
  }
  const auto& corner = model.mesh.joint[at(joint)].corner;
  const double alpha = model.pores.joint_share[at(joint)];
  std::array<double, 2> at_end{};
  for (std::size_t end = 0; end < 2; ++end) {
    at_end[end] =
        0.5 * (model.pores.pressure[at(corner[0][end])] + model.pores.pressure[at(corner[1][end])]);
  }
  return {alpha * (gauss_weight(0) * at_end[0] + gauss_weight(1) * at_end[1]),
          alpha * (gauss_weight(1) * at_end[0] + gauss_weight(0) * at_end[1])};
}

void book_pores(Model& model) {
  if (model.pores.joint_share.empty()) {
    return;
  }
  for (Index j = 0; j < model.mesh.joints(); ++j) {
    if (model.pores.joint_share[at(j)] == 0.0) {
      continue;
    }
    const std::array<double, 2> now = joint_openings(model, j).opening;
    const double half = 0.5 * model.mesh.joint_length(j);
    for (std::size_t g = 0; g < 2; ++g) {
      double& before = model.pores.opening[g][at(j)];
      model.energy.fluid_work += half * model.pores.push[g][at(j)] * (now[g] - before);
      before = now[g];
    }
  }
}

void leave_pores(Model& model, Index joint) {
  if (model.pores.joint_share.empty()) {
    return;
  }
  const JointPoints points = joint_openings(model, joint);
  for (std::size_t g = 0; g < 2; ++g) {
    // The last force acts on from the last places to half a step further.
    const double path = 0.5 * (points.opening[g] - model.pores.opening[g][at(joint)]);
    model.energy.fluid_work +=
        0.5 * model.mesh.joint_length(joint) * model.pores.push[g][at(joint)] * path;
  }
  model.pores.joint_share[at(joint)] = 0.0;
  for (auto& push : model.pores.push) {
    push[at(joint)] = 0.0;
  }
}

}  // namespace percolith::mechanics
