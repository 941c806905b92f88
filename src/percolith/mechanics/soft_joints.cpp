// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/soft_joints.hpp"

#include "percolith/mechanics/joint_points.hpp"

#include <algorithm>
#include <cmath>

namespace percolith::mechanics {
namespace {

/// A joint that holds by more or less than this factor than it did is another one.
constexpr double much = 1.25;
/// The least a bond is taken to hold with, over what it held with when whole. What hangs on it
/// alone would go far out of its way otherwise.
constexpr double least_bond = 0.02;

bool is_there(const Model& model, Index joint) {
  const auto& corner = model.mesh.joint[at(joint)].corner;
  return std::all_of(corner.begin(), corner.end(), [&](const auto& side) {
    return model.triangles.inverse_mass[at(mesh::triangle_of(side[0]))] > 0.0;
  });
}

/// Traction over displacement, from `least_bond` of the full stiffness (Pa/m) to all of it.
double secant(double traction, double displacement, double full) {
  return std::abs(traction) >= std::abs(displacement) * full
             ? full
             : std::max(least_bond * full, std::abs(traction / displacement));
}

SoftJoint soft_joint(const Model& model, const JointTable& table, Index j) {
  const JointPoints points = joint_points(model, table, j);
  const JointState state = model.joints.state[at(j)];
  const double full = model.joints.full_stiffness[at(j)];
  SoftJoint joint{j, {}, {}, points.place.along, points.place.across};
  for (std::size_t g = 0; g < 2; ++g) {
    const bool is_pressed = points.opening[g] <= 0.0;
    if (state == JointState::bonded) {
      joint.normal[g] =
          is_pressed ? full : secant(points.traction[g].normal, points.opening[g], full);
      joint.shear[g] = secant(points.traction[g].shear, points.slip[g], full);
    } else if (is_pressed || state == JointState::closed) {
      joint.normal[g] = full;
      joint.shear[g] = full;
    }
  }
  return joint;
}

bool differ(double a, double b) {
  return a > much * b || b > much * a;
}

}  // namespace

bool is_whole(const Model& model, Index j) {
  const Joints& joints = model.joints;
  const JointState state = joints.state[at(j)];
  const bool holds = state == JointState::tied || state == JointState::rigid ||
                     (state == JointState::bonded && joints.damage[0][at(j)] == 0.0 &&
                      joints.damage[1][at(j)] == 0.0);
  return holds && is_there(model, j);
}

std::vector<SoftJoint> soft_joints(const Model& model, const JointTable& table) {
  std::vector<SoftJoint> soft;
  for (Index j = 0; j < model.mesh.joints(); ++j) {
    if (!is_whole(model, j) && is_there(model, j)) {
      soft.push_back(soft_joint(model, table, j));
    }
  }
  return soft;
}

bool about_the_same(const std::vector<SoftJoint>& a, const std::vector<SoftJoint>& b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(), [](const SoftJoint& one, const SoftJoint& other) {
        bool same = one.joint == other.joint;
        for (std::size_t g = 0; g < 2 && same; ++g) {
          same = !differ(one.normal[g], other.normal[g]) && !differ(one.shear[g], other.shear[g]);
        }
        return same;
      });
}

}  // namespace percolith::mechanics
