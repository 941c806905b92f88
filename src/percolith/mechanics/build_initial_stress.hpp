// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/joint.hpp"

#include <cmath>

namespace percolith::mechanics {

/// A traction t is the same as having been pulled apart by t/k: that is how joints carry it.
template <class Stress>
void set_initial_stress(Model& model, const Stress& stress_at) {
  const mesh::Mesh& mesh = model.mesh;
  make_room_for_stress(model);
  for (Index t = 0; t < mesh.triangles(); ++t) {
    const Tensor s = stress_at(mesh.triangle_centre(t));
    model.triangles.initial_xx[at(t)] = s.xx;
    model.triangles.initial_yy[at(t)] = s.yy;
    model.triangles.initial_xy[at(t)] = s.xy;
  }
  Joints& joints = model.joints;
  for (Index j = 0; j < mesh.joints(); ++j) {
    const double stiffness = joints.full_stiffness[at(j)];
    const Point along = (1.0 / mesh.joint_length(j)) * Point{joints.ex[at(j)], joints.ey[at(j)]};
    const Point across = clockwise(along);
    const auto& ends = mesh.joint[at(j)].vertex;
    for (std::size_t g = 0; g < 2; ++g) {
      const Point place = gauss_weight(g) * mesh.vertex[at(ends[0])] +
                          gauss_weight(1 - g) * mesh.vertex[at(ends[1])];
      const Point traction = stress_at(place) * across;
      joints.opening_start[g][at(j)] = dot(traction, across) / stiffness;
      joints.slip_start[g][at(j)] = dot(traction, along) / stiffness;
    }
  }
  start_closed_joints(model);
}

}  // namespace percolith::mechanics
