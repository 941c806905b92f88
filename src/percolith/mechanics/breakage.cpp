// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/breakage.hpp"

#include "percolith/core/disjoint_sets.hpp"
#include "percolith/mechanics/build.hpp"
#include "percolith/mechanics/joint_points.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace percolith::mechanics {
namespace {

/// Squares of the shares of the ranges of softening that a joint went through, summed over its
/// points.
struct Path {
  double opening = 0.0, slip = 0.0;
};

/// Where one point failed long before the other, its peaks have grown since: each counts as one.
Path path_of(const Model& model, const JointTable& table, const JointPoints& points, Index j) {
  const Joints& joints = model.joints;
  const material::JointConstants<double>& c = table[at(joints.strength[at(j)])];
  const double factor = joints.factor.empty() ? 1.0 : joints.factor[at(j)];
  const double stiffness = joints.full_stiffness[at(j)];
  Path path;
  for (std::size_t g = 0; g < 2; ++g) {
    const double friction = material::frictional_strength(c, points.traction[g].normal);
    const double opening =
        (joints.opening_peak[g][at(j)] - factor * c.tensile / stiffness) * c.opening_range;
    const double slip =
        (joints.slip_peak[g][at(j)] - (factor * c.cohesion + friction) / stiffness) * c.slip_range;
    const double opened = std::clamp(opening, 0.0, 1.0);
    const double slid = std::clamp(slip, 0.0, 1.0);
    const double more = std::max(1.0, opened * opened + slid * slid);
    path.opening += opened * opened / more;
    path.slip += slid * slid / more;
  }
  return path;
}

Mode mode_of(const Path& path) {
  constexpr double pure = 0.9;
  const double opening = path.opening / std::max(path.opening + path.slip, 1e-300);
  if (opening > pure) {
    return Mode::tensile;
  }
  return opening < 1.0 - pure ? Mode::shear : Mode::mixed;
}

bool has_failed(const Model& model, Index j) {
  return model.joints.damage[0][at(j)] >= 1.0 && model.joints.damage[1][at(j)] >= 1.0;
}

std::vector<Index> failed_joints(Model& model) {
  std::vector<Index> failed;
  auto& condition = model.joints.condition;
  const auto is_failed = static_cast<std::uint8_t>(BlockCondition::failed);
  for (auto block = std::find(condition.begin(), condition.end(), is_failed);
       block != condition.end(); block = std::find(block, condition.end(), is_failed)) {
    *block = static_cast<std::uint8_t>(BlockCondition::damaged);
    const auto first = static_cast<Index>(block - condition.begin()) * block_width;
    for (Index j = first; j < first + block_width; ++j) {
      if (has_failed(model, j)) {
        failed.push_back(j);
      }
    }
  }
  return failed;
}

void refresh_fans(Model& model, Index j) {
  model.bonded[at(j)] = 0;
  for (const Index v : model.mesh.joint[at(j)].vertex) {
    model.fans.refresh(model.mesh, model.bonded, v);
  }
}

/// The closed joint a failed one becomes: it carries on the tractions of its last step.
ClosedJoint close(const Model& model, Index j, const JointPoints& points) {
  const JointKind& kind = model.kind[at(model.joints.strength[at(j)])];
  ClosedJoint closed{j, model.joints.full_stiffness[at(j)], kind.residual_friction};
  for (std::size_t g = 0; g < 2; ++g) {
    closed.slip_at_start[g] = points.slip[g];
    closed.slip[g] = points.slip[g];
    closed.shear[g] = points.traction[g].shear;
  }
  return closed;
}

void give_up_bonded(Model& model, const JointTable& table, Changes& changes) {
  std::vector<ClosedJoint> closed;
  for (const Index j : failed_joints(model)) {
    const JointPoints points = joint_points(model, table, j);
    book_bond(model, table, j);
    changes.broke.push_back({j, model.motion.time, mode_of(path_of(model, table, points, j)),
                             model.mesh.joint_length(j), model.joints.past.spent[at(j)]});
    const bool pressed = points.traction[0].normal < 0.0 || points.traction[1].normal < 0.0;
    model.joints.state[at(j)] = pressed ? JointState::closed : JointState::broken;
    if (pressed) {
      closed.push_back(close(model, j, points));
    }
    switch_off(model, j);
    refresh_fans(model, j);
  }
  if (!closed.empty()) {
    const auto middle = static_cast<std::ptrdiff_t>(model.closed.size());
    model.closed.insert(model.closed.end(), closed.begin(), closed.end());
    std::inplace_merge(model.closed.begin(), model.closed.begin() + middle, model.closed.end(),
                       [](const auto& a, const auto& b) { return a.joint < b.joint; });
  }
}

void give_up_closed(Model& model, Changes& changes) {
  changes.parted = ended_closed_joints(model);
  for (const ClosedJointEnd& end : changes.parted) {
    model.joints.state[at(end.joint)] = JointState::broken;
    model.energy.closed_friction += end.friction;
    set_force(model.joints, end.joint, {});
  }
  std::erase_if(model.closed, [&](const ClosedJoint& c) {
    return model.joints.state[at(c.joint)] != JointState::closed;
  });
}

}  // namespace

Changes break_failed_joints(Model& model, const JointTable& table) {
  Changes changes;
  give_up_bonded(model, table, changes);
  give_up_closed(model, changes);
  return changes;
}

Fragments find_fragments(const Model& model) {
  const Index n = model.mesh.triangles();
  DisjointSets parts(n);
  for (Index j = 0; j < model.mesh.joints(); ++j) {
    if (model.bonded[at(j)] != 0) {
      const auto& corner = model.mesh.joint[at(j)].corner;
      parts.merge(mesh::triangle_of(corner[0][0]), mesh::triangle_of(corner[1][0]));
    }
  }
  Fragments fragments;
  fragments.number.assign(at(n), mesh::none);
  for (Index t = 0; t < n; ++t) {
    if (model.triangles.inverse_mass[at(t)] == 0.0) {
      continue;
    }
    const Index root = parts.root(t);
    if (root == t) {
      fragments.number[at(t)] = static_cast<Index>(fragments.area.size());
      fragments.area.push_back(0.0);
    } else {
      fragments.number[at(t)] = fragments.number[at(root)];
    }
    fragments.area[at(fragments.number[at(t)])] += model.mesh.area(t);
  }
  return fragments;
}

}  // namespace percolith::mechanics
