// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/joint_flow.hpp"

namespace percolith::seepage {
namespace {

/// Where the entry of a joint stands for each of its sides: the first triangle walks the edge from
/// end 0 to end 1, the second the other way round.
std::array<Index, 2> edge_slots(const mesh::Joint& joint) {
  return {joint.corner[0][0], joint.corner[1][1]};
}

}  // namespace

JointsAcross joints_across(const Model& model) {
  const auto slots = at(model.mesh.corners());
  JointsAcross across;
  across.conductance.assign(slots, 0.0);
  across.start.resize(slots);
  across.end.resize(slots);
  for (Index c = 0; c < model.mesh.corners(); ++c) {
    across.start[at(c)] = c;
    across.end[at(c)] = mesh::corner_of(mesh::triangle_of(c), (mesh::local_of(c) + 1) % 3);
  }
  for (Index j = 0; j < model.mesh.joints(); ++j) {
    if (model.cracks.is_broken(j)) {
      continue;
    }
    const mesh::Joint& joint = model.mesh.joint[at(j)];
    const auto slot = edge_slots(joint);
    across.conductance[at(slot[0])] = model.pore.joint[at(j)];
    across.start[at(slot[0])] = joint.corner[1][0];
    across.end[at(slot[0])] = joint.corner[1][1];
    across.conductance[at(slot[1])] = model.pore.joint[at(j)];
    across.start[at(slot[1])] = joint.corner[0][1];
    across.end[at(slot[1])] = joint.corner[0][0];
  }
  return across;
}

void close_joint(const Model& model, Index joint, JointsAcross& across) {
  for (const Index slot : edge_slots(model.mesh.joint[at(joint)])) {
    across.conductance[at(slot)] = 0.0;
  }
}

}  // namespace percolith::seepage
