// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/excavation.hpp"

#include "percolith/mechanics/build.hpp"
#include "percolith/mechanics/closed_joints.hpp"
#include "percolith/mechanics/energy.hpp"
#include "percolith/mechanics/joint_points.hpp"
#include "percolith/mechanics/pressed_faces.hpp"
#include "percolith/mechanics/solid_forces.hpp"
#include "percolith/mechanics/strain.hpp"
#include "percolith/mechanics/wet_joints.hpp"

#include <algorithm>

namespace percolith::mechanics {
namespace {

/// Forces of stress, pore pressure and gravity on the corners of a triangle, N/m.
CornerForces<double> own_forces(const Model& model, Index t) {
  const Triangles& tri = model.triangles;
  const auto shape =
      triangle_shape(Point{tri.ax[at(t)], tri.ay[at(t)]}, Point{tri.bx[at(t)], tri.by[at(t)]});
  const TriangleStrain strained = triangle_strain(model, t);
  Tensor s =
      material::stress_of(model.material[at(tri.material[at(t)])].stiffness, strained.strain);
  if (!tri.initial_xx.empty()) {
    s.xx += tri.initial_xx[at(t)];
    s.yy += tri.initial_yy[at(t)];
    s.xy += tri.initial_xy[at(t)];
  }
  CornerForces<double> force = corner_forces(shape, strained.gradient, s);
  const SolidForces kernel(model);
  if (kernel.is_wet()) {
    const Index first = mesh::corner_of(t, 0);
    const auto pores = kernel.of_pores<ScalarLane>(
        t, load_corners<ScalarLane>(model.motion.ux.data(), model.motion.uy.data(), first));
    for (std::size_t k = 0; k < 3; ++k) {
      force[k] = force[k] + pores[k];
    }
  }
  for (Point& f : force) {
    f.y -= tri.weight.empty() ? 0.0 : tri.weight[at(t)];
  }
  return force;
}

/// What the removed corners of shared nodes give to a corner of the rest of the same node.
void support_by_nodes(const Model& model, std::span<const std::uint8_t> removed,
                      std::span<const Index> triangles, std::vector<CornerForce>& support) {
  const SolidForces forces(model);
  for (const Index t : triangles) {
    const CornerForces<double> own = own_forces(model, t);
    const CornerVectors<double> joints = forces.of_joints<ScalarLane>(mesh::corner_of(t, 0));
    for (Index k = 0; k < 3; ++k) {
      const Index corner = mesh::corner_of(t, k);
      Index kept = mesh::none;
      model.nodes.for_each_corner(model.mesh, model.nodes.leader(corner), [&](Index c) {
        if (kept == mesh::none && removed[at(mesh::triangle_of(c))] == 0) {
          kept = c;
        }
      });
      if (kept != mesh::none) {
        const Point load{model.loads.fx[at(corner)], model.loads.fy[at(corner)]};
        support.push_back({kept, own[at(k)] + joints[at(k)] + load});
      }
    }
  }
}

/// Brings the forces of the joints of the removed triangles up to the present places: those in the
/// arrays are of the step before, or of none at all.
void renew_joint_forces(Model& model, const JointTable& table,
                        std::span<const std::uint8_t> removed) {
  for (Index j = 0; j < model.mesh.joints(); ++j) {
    const auto& corner = model.mesh.joint[at(j)].corner;
    if (removed[at(mesh::triangle_of(corner[0][0]))] == 0 &&
        removed[at(mesh::triangle_of(corner[1][0]))] == 0) {
      continue;
    }
    const bool closed = model.joints.state[at(j)] == JointState::closed;
    const std::array<Point, 2> fluid = force_of_fluid(model, j);
    if (!closed && model.joints.state[at(j)] != JointState::bonded) {
      set_force(model.joints, j, fluid);
      continue;
    }
    const JointPoints points = joint_points(model, table, j);
    const auto entry =
        std::lower_bound(model.closed.begin(), model.closed.end(), j,
                         [](const ClosedJoint& c, Index wanted) { return c.joint < wanted; });
    auto traction = closed ? closed_tractions(model, *entry) : points.traction;
    const std::array<double, 2> push = push_in_joint(model, j);
    for (std::size_t g = 0; g < 2; ++g) {
      traction[g].normal -= push[g];
    }
    auto force = joint_forces(points.place, model.mesh.joint_length(j), traction);
    for (std::size_t end = 0; end < 2; ++end) {
      force[end] = force[end] + fluid[end];
    }
    set_force(model.joints, j, force);
  }
}

/// What the joints between the removed triangles and the rest carry.
void support_by_joint(const Model& model, Index j, std::size_t kept_side,
                      std::vector<CornerForce>& support) {
  const double* force = model.joints.force.data() + force_slot(j);
  const double sign = kept_side == 0 ? 1.0 : -1.0;
  for (std::size_t end = 0; end < 2; ++end) {
    const double* f = force + 2 * block_width * static_cast<Index>(end);
    support.push_back(
        {model.mesh.joint[at(j)].corner[kept_side][end], sign * Point{f[0], f[block_width]}});
  }
}

/// Edge of a triangle of the rest that the opening lays bare, in the order of its corners.
std::array<Index, 2> wall_of(const mesh::Mesh& mesh, Index j, std::size_t kept_side) {
  const std::array<Index, 2>& ends = mesh.joint[at(j)].corner[kept_side];
  const Index t = mesh::triangle_of(ends[0]);
  for (Index k = 0; k < 3; ++k) {
    const std::array<Index, 2> edge{mesh::corner_of(t, k), mesh::corner_of(t, (k + 1) % 3)};
    if (edge[0] == ends[1] && edge[1] == ends[0]) {
      return edge;
    }
  }
  return ends;
}

double energy_held(const Model& model, Index t) {
  double energy = elastic_energy_of(model, t);
  for (Index k = 0; k < 3; ++k) {
    const auto c = at(mesh::corner_of(t, k));
    const Point v{model.motion.vx[c], model.motion.vy[c]};
    energy += 0.5 / model.triangles.inverse_mass[at(t)] * dot(v, v);
  }
  return energy;
}

void forget_joint(Model& model, Index j) {
  switch_off(model, j);
  model.joints.state[at(j)] = JointState::broken;
  model.tied[at(j)] = 0;
  model.bonded[at(j)] = 0;
}

void stop_triangle(Model& model, Index t) {
  model.triangles.inverse_mass[at(t)] = 0.0;
  for (Index k = 0; k < 3; ++k) {
    const auto c = at(mesh::corner_of(t, k));
    model.motion.vx[c] = 0.0;
    model.motion.vy[c] = 0.0;
  }
  if (!model.triangles.weight.empty()) {
    model.triangles.weight[at(t)] = 0.0;
  }
}

}  // namespace

FadingSupport remove_triangles(Model& model, const JointTable& table,
                               std::span<const Index> triangles,
                               std::span<const std::uint8_t> removed, double duration) {
  Execution serial(Backend::serial);
  const double stored_before = stored_in_joints(model, table, serial);
  renew_joint_forces(model, table, removed);
  FadingSupport support;
  support.start = model.motion.time;
  support.duration = duration;
  support_by_nodes(model, removed, triangles, support.force);
  std::vector<Index> vertices;
  for (Index j = 0; j < model.mesh.joints(); ++j) {
    const auto& corner = model.mesh.joint[at(j)].corner;
    const bool first = removed[at(mesh::triangle_of(corner[0][0]))] != 0;
    const bool second = removed[at(mesh::triangle_of(corner[1][0]))] != 0;
    if (first || second) {
      const std::size_t kept_side = first ? 1 : 0;
      if (first != second && model.tied[at(j)] == 0) {
        support_by_joint(model, j, kept_side, support.force);
      }
      if (first != second) {
        support.wall.push_back(wall_of(model.mesh, j, kept_side));
      }
      book_bond(model, table, j);
      leave_pores(model, j);
      forget_joint(model, j);
      const auto& ends = model.mesh.joint[at(j)].vertex;
      vertices.insert(vertices.end(), ends.begin(), ends.end());
    }
  }
  for (const Index t : triangles) {
    model.energy.taken_out += energy_held(model, t);
    stop_triangle(model, t);
  }
  std::erase_if(model.closed, [&](const ClosedJoint& c) {
    return model.joints.state[at(c.joint)] != JointState::closed;
  });
  forget_pressed(model, [&](Index j) {
    const auto& corner = model.mesh.joint[at(j)].corner;
    return removed[at(mesh::triangle_of(corner[0][0]))] != 0 ||
           removed[at(mesh::triangle_of(corner[1][0]))] != 0;
  });
  for (const Index v : vertices) {
    model.nodes.refresh(model.mesh, model.tied, v);
    model.fans.refresh(model.mesh, model.bonded, v);
  }
  model.energy.joints_taken_out += stored_before - stored_in_joints(model, table, serial);
  return support;
}

}  // namespace percolith::mechanics
