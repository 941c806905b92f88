// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/build.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace percolith::mechanics {
namespace {

Index material_of(const Ingredients& from, const mesh::Mesh& mesh, Index t) {
  return from.region_material[at(mesh.region[at(t)])];
}

/// 1 for each block of eight whose entries are all alike.
std::vector<std::uint8_t> uniform_blocks(const std::vector<Index>& index) {
  std::vector<std::uint8_t> uniform(index.size() / block_width);
  for (std::size_t b = 0; b < uniform.size(); ++b) {
    const auto first = index.begin() + static_cast<std::ptrdiff_t>(b * block_width);
    uniform[b] =
        std::all_of(first, first + block_width, [&](Index i) { return i == *first; }) ? 1 : 0;
  }
  return uniform;
}

/// Element viscosity, given or as a share of 2 h sqrt(E rho), which damps the shortest waves
/// critically.
double viscosity_of(const SolidMaterial& m, double size) {
  return m.viscosity +
         m.viscosity_ratio * 2.0 * size * std::sqrt(m.rock.young_modulus * m.rock.density);
}

Triangles make_triangles(const mesh::Mesh& mesh, const Ingredients& from) {
  const auto n = at(padded(mesh.triangles()));
  Triangles t;
  t.ax.assign(n, 1.0);
  t.ay.assign(n, 0.0);
  t.bx.assign(n, 0.0);
  t.by.assign(n, 1.0);
  t.inverse_mass.assign(n, 0.0);
  t.weight.assign(from.gravity > 0.0 ? n : 0, 0.0);
  const bool viscous =
      std::any_of(from.material.begin(), from.material.end(),
                  [](const SolidMaterial& m) { return m.viscosity > 0 || m.viscosity_ratio > 0; });
  t.viscosity.assign(viscous ? n : 0, 0.0);
  t.material.assign(n, material_of(from, mesh, mesh.triangles() - 1));
  for (Index i = 0; i < mesh.triangles(); ++i) {
    const auto p = mesh.triangle_points(i);
    t.ax[at(i)] = p[1].x - p[0].x;
    t.ay[at(i)] = p[1].y - p[0].y;
    t.bx[at(i)] = p[2].x - p[0].x;
    t.by[at(i)] = p[2].y - p[0].y;
    t.material[at(i)] = material_of(from, mesh, i);
    const SolidMaterial& m = from.material[at(t.material[at(i)])];
    const double mass = m.rock.density * mesh.area(i) / 3.0;
    t.inverse_mass[at(i)] = 1.0 / mass;
    if (from.gravity > 0.0) {
      t.weight[at(i)] = mass * from.gravity;
    }
    if (viscous) {
      t.viscosity[at(i)] = viscosity_of(m, element_size(mesh, i));
    }
  }
  t.uniform = uniform_blocks(t.material);
  return t;
}

/// Size and stiffness of a joint; its penalty is that of its kind or follows from both sides.
void measure_joint(const mesh::Mesh& mesh, const Ingredients& from, Index j, Joints& joints) {
  const auto& corner = mesh.joint[at(j)].corner;
  const Index first = mesh::triangle_of(corner[0][0]);
  const Index second = mesh::triangle_of(corner[1][0]);
  joints.size[at(j)] = 0.5 * (element_size(mesh, first) + element_size(mesh, second));
  const double softer =
      std::min(from.material[at(material_of(from, mesh, first))].rock.young_modulus,
               from.material[at(material_of(from, mesh, second))].rock.young_modulus);
  const JointKind& kind = from.kind[at(from.joint_kind[at(j)])];
  const double penalty = kind.strength.joint_penalty.value_or(default_penalty * softer);
  joints.full_stiffness[at(j)] = penalty / joints.size[at(j)];
}

/// Marks a block none of whose joints is bonded.
void note_if_gone(Joints& joints, std::size_t block) {
  const auto first = joints.stiffness.begin() + static_cast<std::ptrdiff_t>(block * block_width);
  if (std::all_of(first, first + block_width, [](double k) { return k == 0.0; })) {
    joints.condition[block] = static_cast<std::uint8_t>(BlockCondition::gone);
  }
}

Joints make_joints(const mesh::Mesh& mesh, const Ingredients& from) {
  // One joint more than there are: edges without a joint refer to it.
  const auto n = at(padded(mesh.joints() + 1));
  Joints joints;
  joints.slot.assign(4 * n, 0);
  joints.ex.assign(n, 1.0);
  joints.ey.assign(n, 0.0);
  joints.length.assign(n, 1.0);
  joints.stiffness.assign(n, 0.0);
  joints.full_stiffness.assign(n, 0.0);
  joints.size.assign(n, 1.0);
  joints.strength.assign(n, from.joint_kind.empty() ? 0 : from.joint_kind.back());
  joints.factor = from.joint_factor;
  if (!joints.factor.empty()) {
    joints.factor.resize(n, 1.0);
  }
  for (std::size_t g = 0; g < 2; ++g) {
    joints.opening_peak[g].assign(n, 0.0);
    joints.slip_peak[g].assign(n, 0.0);
    joints.damage[g].assign(n, 0.0);
    for (auto* past : {&joints.past.opening, &joints.past.slip, &joints.past.normal,
                       &joints.past.shear, &joints.past.slope, &joints.past.friction}) {
      (*past)[g].assign(n, 0.0);
    }
  }
  joints.past.spent.assign(n, 0.0);
  joints.past.rubbed.assign(n, 0.0);
  joints.state.assign(n, JointState::tied);
  joints.force.assign(4 * n, 0.0);
  joints.condition.assign(n / block_width, 0);
  for (Index j = 0; j < mesh.joints(); ++j) {
    const mesh::Joint& joint = mesh.joint[at(j)];
    const Point edge = mesh.vertex[at(joint.vertex[1])] - mesh.vertex[at(joint.vertex[0])];
    joints.ex[at(j)] = edge.x;
    joints.ey[at(j)] = edge.y;
    joints.length[at(j)] = square_root(dot(edge, edge));
    joints.strength[at(j)] = from.joint_kind[at(j)];
    joints.state[at(j)] = from.joint_state[at(j)];
    measure_joint(mesh, from, j, joints);
    if (joints.state[at(j)] == JointState::bonded) {
      joints.stiffness[at(j)] = joints.full_stiffness[at(j)];
    }
    Index slot = force_slot(j);
    for (const auto& side : joint.corner) {
      for (const Index corner : side) {
        joints.slot[at(slot)] = corner;
        slot += block_width;
      }
    }
  }
  joints.uniform = uniform_blocks(joints.strength);
  for (std::size_t block = 0; block < joints.condition.size(); ++block) {
    note_if_gone(joints, block);
  }
  return joints;
}

std::vector<Index> edge_joints(const mesh::Mesh& mesh) {
  std::vector<Index> code(at(mesh.corners()), edge_code(mesh.joints(), 0));
  for (Index j = 0; j < mesh.joints(); ++j) {
    const auto& corner = mesh.joint[at(j)].corner;
    code[at(corner[0][0])] = edge_code(j, 0);
    code[at(corner[1][1])] = edge_code(j, 1);
  }
  return code;
}

std::vector<ClosedJoint> closed_joints(const Joints& joints, const Ingredients& from, Index count) {
  std::vector<ClosedJoint> closed;
  for (Index j = 0; j < count; ++j) {
    if (joints.state[at(j)] == JointState::closed) {
      closed.push_back({j,
                        joints.full_stiffness[at(j)],
                        from.kind[at(joints.strength[at(j)])].residual_friction,
                        {},
                        {}});
    }
  }
  return closed;
}

}  // namespace

double element_size(const mesh::Mesh& mesh, Index t) {
  return 2.0 * std::sqrt(mesh.area(t) / std::sqrt(3.0));
}

double softer_modulus(const Model& model, Index joint) {
  const auto modulus = [&](std::size_t side) {
    const Index t = mesh::triangle_of(model.mesh.joint[at(joint)].corner[side][0]);
    return material::plane_modulus(model.material[at(model.triangles.material[at(t)])].rock,
                                   model.plane);
  };
  return std::min(modulus(0), modulus(1));
}

Model make_model(mesh::Mesh mesh, Ingredients from) {
  for (SolidMaterial& m : from.material) {
    m.stiffness = material::plane_stiffness(m.rock, from.plane);
  }
  std::vector<std::uint8_t> tied(at(mesh.joints()));
  std::vector<std::uint8_t> bonded(at(mesh.joints()));
  for (std::size_t j = 0; j < tied.size(); ++j) {
    tied[j] = from.joint_state[j] == JointState::tied ? 1 : 0;
    bonded[j] =
        from.joint_state[j] != JointState::closed && from.joint_state[j] != JointState::broken ? 1
                                                                                               : 0;
  }
  Triangles triangles = make_triangles(mesh, from);
  triangles.edge_joint = edge_joints(mesh);
  Joints joints = make_joints(mesh, from);
  std::vector<ClosedJoint> closed = closed_joints(joints, from, mesh.joints());
  mesh::NodeMap nodes(mesh, tied);
  mesh::NodeMap fans(mesh, bonded);
  const auto slots = at(mesh.corners());
  const auto blocks = at(padded(mesh.triangles())) / block_width;
  const std::vector<double> zero(slots, 0.0);
  const bool any_tied = std::any_of(tied.begin(), tied.end(), [](auto flag) { return flag != 0; });
  Model model{.mesh = std::move(mesh),
              .plane = from.plane,
              .material = std::move(from.material),
              .kind = std::move(from.kind),
              .damping = from.damping,
              .triangles = std::move(triangles),
              .joints = std::move(joints),
              .closed = std::move(closed),
              .tied = std::move(tied),
              .bonded = std::move(bonded),
              .nodes = std::move(nodes),
              .fans = std::move(fans),
              .any_tied = any_tied,
              .constraints = {},
              .loads = {zero, zero, std::vector<std::uint8_t>(blocks, 0)},
              .motion = {0.0, 0.0, zero, zero, zero, zero},
              .energy = {}};
  model.constraints.record.assign(blocks, mesh::none);
  return model;
}

void make_room_for_stress(Model& model) {
  auto& t = model.triangles;
  for (auto* values : {&t.initial_xx, &t.initial_yy, &t.initial_xy}) {
    values->resize(at(padded(model.mesh.triangles())), 0.0);
  }
  for (std::size_t g = 0; g < 2; ++g) {
    model.joints.opening_start[g].resize(model.joints.ex.size(), 0.0);
    model.joints.slip_start[g].resize(model.joints.ex.size(), 0.0);
  }
}

void start_closed_joints(Model& model) {
  const Joints& joints = model.joints;
  for (ClosedJoint& closed : model.closed) {
    for (std::size_t g = 0; g < 2; ++g) {
      const auto j = at(closed.joint);
      const double limit =
          closed.friction * closed.stiffness * std::max(0.0, -joints.opening_start[g][j]);
      closed.slip_at_start[g] = joints.slip_start[g][j];
      closed.slip[g] = joints.slip_start[g][j];
      closed.shear[g] = std::clamp(closed.stiffness * joints.slip_start[g][j], -limit, limit);
    }
  }
}

void switch_off(Model& model, Index joint) {
  const auto j = at(joint);
  model.joints.stiffness[j] = 0.0;
  for (std::size_t g = 0; g < 2; ++g) {
    model.joints.opening_peak[g][j] = 0.0;
    model.joints.slip_peak[g][j] = 0.0;
    model.joints.damage[g][j] = 0.0;
    model.joints.past.normal[g][j] = 0.0;
    model.joints.past.shear[g][j] = 0.0;
    model.joints.past.slope[g][j] = 0.0;
    model.joints.past.friction[g][j] = 0.0;
  }
  set_force(model.joints, joint, {});
  note_if_gone(model.joints, j / block_width);
}

void set_force(Joints& joints, Index joint, const std::array<Point, 2>& on_first) {
  double* out = joints.force.data() + force_slot(joint);
  for (const Point& f : on_first) {
    out[0] = f.x;
    out[block_width] = f.y;
    out += 2 * block_width;
  }
}

}  // namespace percolith::mechanics
