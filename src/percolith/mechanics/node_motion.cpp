// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/node_motion.hpp"

namespace percolith::mechanics {

void NodeBuffers::resize(Index corners) {
  for (auto* values :
       {&stress_x, &stress_y, &viscous_x, &viscous_y, &joint_x, &joint_y, &new_vx, &new_vy}) {
    values->resize(at(corners), 0.0);
  }
}

void MoveNodes::operator()(ScalarLane lane, LaneSums<terms>& sums) const {
  for (const Index node : mesh->vertex_corners.row(lane.first)) {
    if (nodes->leader(node) == node) {
      move_node(lane, node, sums);
    }
  }
}

void MoveNodes::move_node(ScalarLane lane, Index node, LaneSums<terms>& sums) const {
  const NodeBuffers& b = *buffers;
  Point total{0.0, 0.0};
  double mass = 0.0;
  nodes->for_each_corner(*mesh, node, [&](Index corner) {
    const Index t = mesh::triangle_of(corner);
    const double w = move.inverse_mass[t];
    mass += w > 0.0 ? 1.0 / w : 0.0;
    Point force{b.stress_x[at(corner)] + b.joint_x[at(corner)],
                b.stress_y[at(corner)] + b.joint_y[at(corner)]};
    if (move.contact_acts != nullptr && move.contact_acts[t / block_width] != 0) {
      force = force + Point{move.contact_x[corner], move.contact_y[corner]};
    }
    if (move.load_acts[t / block_width] != 0) {
      force = force + Point{move.load_x[corner], move.load_y[corner]};
    }
    if (move.weight != nullptr) {
      force.y -= move.weight[t];
    }
    total = total + force;
  });
  const double w = mass > 0.0 ? 1.0 / mass : 0.0;
  const Point before{move.vx[node], move.vy[node]};
  const Point after = move.move_corner(lane, node, total, before, w, sums);
  nodes->for_each_corner(*mesh, node, [&](Index corner) {
    buffers->new_vx[at(corner)] = after.x;
    buffers->new_vy[at(corner)] = after.y;
    // The reaction of the node stands at its leader.
    if (corner != node) {
      move.clear_reaction(corner);
    }
  });
}

}  // namespace percolith::mechanics
