// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/joint_points.hpp"

namespace percolith::mechanics {

JointPoints joint_openings(const Model& model, Index j, double back) {
  const mesh::Joint& joint = model.mesh.joint[at(j)];
  const Joints& joints = model.joints;
  std::array<std::array<Point, 2>, 2> u;
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t end = 0; end < 2; ++end) {
      const auto c = at(joint.corner[side][end]);
      u[side][end] = {model.motion.ux[c] - back * model.motion.vx[c],
                      model.motion.uy[c] - back * model.motion.vy[c]};
    }
  }
  JointPoints points{joint_place(Point{joints.ex[at(j)], joints.ey[at(j)]}, u)};
  for (std::size_t g = 0; g < 2; ++g) {
    const Point apart = apart_at(points.place, g);
    points.opening[g] = dot(apart, points.place.across);
    points.slip[g] = dot(apart, points.place.along);
    if (!joints.opening_start[g].empty()) {
      points.opening[g] += joints.opening_start[g][at(j)];
      points.slip[g] += joints.slip_start[g][at(j)];
    }
  }
  return points;
}

material::JointConstants<double> joint_constants(const Model& model, const JointTable& table,
                                                 Index j) {
  const Joints& joints = model.joints;
  material::JointConstants<double> c = table[at(joints.strength[at(j)])];
  c.stiffness = joints.stiffness[at(j)];
  if (!joints.factor.empty()) {
    c.tensile *= joints.factor[at(j)];
    c.cohesion *= joints.factor[at(j)];
  }
  return c;
}

JointPoints joint_points(const Model& model, const JointTable& table, Index j, double back) {
  const Joints& joints = model.joints;
  JointPoints points = joint_openings(model, j, back);
  const material::JointConstants<double> c = joint_constants(model, table, j);
  for (std::size_t g = 0; g < 2; ++g) {
    material::JointMemory<double> memory{
        joints.opening_peak[g][at(j)], joints.slip_peak[g][at(j)],     joints.damage[g][at(j)],
        joints.past.slope[g][at(j)],   joints.past.friction[g][at(j)], joints.past.slip[g][at(j)]};
    points.traction[g] = material::softening_traction(c, points.opening[g], points.slip[g], memory);
    points.moment[g] =
        material::moment_of(c, points.opening[g], points.slip[g], points.traction[g], memory);
  }
  return points;
}

material::JointLoss<double> bond_loss_since(const Model& model, const JointTable& table, Index j,
                                            double back) {
  material::JointLoss<double> sum{};
  const Joints& joints = model.joints;
  if (joints.damage[0][at(j)] == 0.0 && joints.damage[1][at(j)] == 0.0) {
    return sum;
  }
  const material::JointConstants<double> c = joint_constants(model, table, j);
  const JointPoints points = joint_points(model, table, j, back);
  for (std::size_t g = 0; g < 2; ++g) {
    const JointPast& past = joints.past;
    const material::JointMoment<double> before{past.opening[g][at(j)],
                                               past.slip[g][at(j)],
                                               {past.normal[g][at(j)], past.shear[g][at(j)]},
                                               past.slope[g][at(j)],
                                               past.friction[g][at(j)],
                                               joints.damage[g][at(j)]};
    const auto lost = material::joint_loss(c, before, points.moment[g]);
    sum.bond += 0.5 * model.mesh.joint_length(j) * lost.bond;
    sum.friction += 0.5 * model.mesh.joint_length(j) * lost.friction;
  }
  return sum;
}

void book_bond(Model& model, const JointTable& table, Index j) {
  const material::JointLoss<double> loss = bond_loss_since(model, table, j, 0.0);
  model.joints.past.spent[at(j)] += loss.bond;
  model.joints.past.rubbed[at(j)] += loss.friction;
}

}  // namespace percolith::mechanics
