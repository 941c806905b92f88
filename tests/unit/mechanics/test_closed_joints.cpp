// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/closed_joints.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/support/joint_pair.hpp"
#include "unit/support/solid_model.hpp"

namespace percolith::mechanics {
namespace {

using test::JointPair;

constexpr double pressure = 5e6;

double pressed() {
  return pressure / JointPair::stiffness();
}

JointKind rock(double residual_friction) {
  return test::joint_kind(3e6, 6e6, 50.0, 100.0, 0.6, residual_friction);
}

TEST(ClosedJoints, AJointShearedUnderCompressionKeepsItsForceWhenItBreaks) {
  const JointKind kind = rock(0.6);
  const double way = JointPair::slip_at_failure(kind, pressure);
  JointPair pair(kind, {{{0.0, 0.9998 * way}, 20000}, {{0.0, 0.0004 * way}, 8}}, pressed());
  EXPECT_TRUE(pair.move().broke.empty());
  const Point before = pair.joint_force();
  const auto broke = pair.move().broke;
  ASSERT_EQ(broke.size(), 1u);
  EXPECT_EQ(broke[0].mode, Mode::shear);
  EXPECT_EQ(pair.model().joints.state[0], JointState::closed);
  const Point after = pair.joint_force();
  EXPECT_NEAR(after.x, before.x, 1e-6 * std::abs(before.x));
  // The last of the bond goes, friction stays.
  EXPECT_NEAR(after.y, before.y, 1e-3 * before.y);
  EXPECT_NEAR(after.x, -pressure * JointPair::length, 1e-6 * pressure);
  EXPECT_NEAR(after.y, 0.6 * pressure * JointPair::length, 1e-6 * pressure);
}

TEST(ClosedJoints, ResidualFrictionRulesOnceTheBondIsGone) {
  const JointKind kind = rock(0.25);
  const double way = JointPair::slip_at_failure(kind, pressure);
  JointPair pair(kind, {{{0.0, 1.1 * way}, 4000}}, pressed());
  ASSERT_EQ(pair.move().broke.size(), 1u);
  EXPECT_NEAR(pair.joint_force().y, 0.25 * pressure * JointPair::length, 1e-6 * pressure);
}

TEST(ClosedJoints, SticksThenSlidesThenTurnsBack) {
  const double k = JointPair::stiffness();
  const double limit = 0.4 * pressure;
  const double yield = limit / k;
  JointPair pair(rock(0.4),
                 {{{0.0, 0.5 * yield}, 100}, {{0.0, 2.5 * yield}, 500}, {{0.0, -0.5 * yield}, 100}},
                 pressed(), JointState::closed);
  pair.move();
  // Forces are those before the last step: a hundredth of the leg is still to come.
  EXPECT_NEAR(pair.joint_force().y, 0.495 * limit * JointPair::length, 1e-3 * limit);
  EXPECT_NEAR(pair.energy().friction, 0.0, 1e-9);
  pair.move();
  EXPECT_NEAR(pair.joint_force().y, limit * JointPair::length, 1e-6 * limit);
  // Slid by 2 of the 3 lengths of yielding.
  EXPECT_NEAR(pair.energy().friction, 2 * yield * limit * JointPair::length,
              0.01 * yield * limit * JointPair::length);
  pair.move();
  EXPECT_NEAR(pair.joint_force().y, (1 - 0.495) * limit * JointPair::length, 1e-3 * limit);
  const EnergyBalance e = pair.energy();
  EXPECT_NEAR(e.friction, 2 * yield * limit * JointPair::length, 1e-3 * e.friction);
  EXPECT_LT(std::abs(e.fracture), 0.01 * e.friction);
  EXPECT_LT(std::abs(e.residual), 1e-3 * e.friction);
}

TEST(ClosedJoints, InSituShearBeyondFrictionIsNotPaidFor) {
  Model model = test::make_solid(test::make_grid({.columns = 2, .rows = 2}),
                                 {.kind = rock(0.1), .joints = JointState::closed});
  set_initial_stress(model, [](Point) { return Tensor{-4e6, -1e6, 1e6}; });
  Dynamics dynamics = test::make_dynamics(std::move(model));
  test::advance(dynamics, 1e-9, 1);
  EXPECT_LT(dynamics.energy(Execution()).friction, 1e-6);
}

TEST(ClosedJoints, FacesThatHaveSlidBalanceTheirMoments) {
  JointPair pair(rock(0.4), {{{0.0, 0.05 * JointPair::length}, 2000}, {{0.0, 0.0}, 2}}, pressed(),
                 JointState::closed);
  pair.move();
  pair.move();
  const Model& model = pair.model();
  double of_faces = 0.0;
  double all = 0.0;
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t end = 0; end < 2; ++end) {
      const Index c = model.mesh.joint[0].corner[side][end];
      const Point p = model.mesh.place_of(c) + test::displacement(model, c);
      const double* f = model.joints.force.data() + 2 * block_width * static_cast<Index>(end);
      const Point face = (side == 0 ? 1.0 : -1.0) * Point{f[0], f[block_width]};
      const Point turn{pair.dynamics().contact().force_x()[at(c)],
                       pair.dynamics().contact().force_y()[at(c)]};
      of_faces += cross(p, face);
      all += cross(p, face + turn);
    }
  }
  const double scale = pressure * JointPair::length * JointPair::length;
  EXPECT_GT(std::abs(of_faces), 0.04 * scale);
  EXPECT_LT(std::abs(all), 1e-12 * scale);
}

TEST(ClosedJoints, PullingPartsTheFaces) {
  JointPair pair(rock(0.4), {{{0.5 * pressed(), 0.0}, 10}, {{pressed(), 0.0}, 10}}, pressed(),
                 JointState::closed);
  EXPECT_TRUE(pair.move().parted.empty());
  EXPECT_EQ(pair.model().joints.state[0], JointState::closed);
  const auto parted = pair.move().parted;
  ASSERT_EQ(parted.size(), 1u);
  EXPECT_EQ(parted[0].normal_force, 0.0);
  EXPECT_EQ(pair.model().joints.state[0], JointState::broken);
  EXPECT_TRUE(pair.model().closed.empty());
  EXPECT_EQ(pair.joint_force().x, 0.0);
}

TEST(ClosedJoints, ContactTakesOverWithoutAJumpOfForceOrEnergy) {
  // Fast up to the place, slowly past it: energies are those half a step ago.
  const double slow = 0.0004 * JointPair::length;
  JointPair pair(rock(0.4),
                 {{{0.0, 0.0998 * JointPair::length}, 20000},
                  {{0.0, 0.25 * slow}, 400},
                  {{0.0, slow}, 1600},
                  {{0.0, 0.01 * JointPair::length}, 2000}},
                 pressed(), JointState::closed);
  pair.move();
  EXPECT_TRUE(pair.move().parted.empty());
  const Point closed = pair.joint_force();
  EXPECT_EQ(pair.contact_force().x, 0.0);
  const EnergyBalance before = pair.energy();
  const auto parted = pair.move().parted;
  ASSERT_EQ(parted.size(), 1u);
  EXPECT_NEAR(parted[0].normal_force, -closed.x, 1e-6 * pressure);
  const Point contact = pair.contact_force();
  const double force = pressure * JointPair::length;
  EXPECT_EQ(pair.joint_force().x, 0.0);
  EXPECT_NEAR(contact.x, closed.x, 0.01 * force);
  EXPECT_NEAR(contact.y, closed.y, 0.01 * force);
  const EnergyBalance after = pair.energy();
  // The work of the little way went into friction; nothing sprang up.
  const double work = 0.4 * force * slow;
  EXPECT_NEAR(after.friction - before.friction, work, 0.05 * work);
  EXPECT_NEAR(after.external - before.external, work, 0.05 * work);
  EXPECT_NEAR(after.joint + after.contact, before.joint + before.contact, 0.05 * before.joint);
  EXPECT_EQ(after.joint, 0.0);
  EXPECT_NEAR(after.fracture, before.fracture, 0.05 * work);
  pair.move();
  const EnergyBalance end = pair.energy();
  EXPECT_GT(end.contact, 0.0);
  EXPECT_LT(std::abs(end.residual), 1e-3 * end.external);
  EXPECT_LT(std::abs(end.fracture), 0.01 * end.external);
}

TEST(ClosedJoints, OverTheWholeWayFromBondToContactTheEnergyIsThatOfTheLaw) {
  const JointKind kind = rock(0.6);
  JointPair pair(kind, {{{0.0, 0.002}, 20000}, {{0.0, 0.15}, 60000}}, pressed());
  ASSERT_EQ(pair.move().broke.size(), 1u);
  ASSERT_EQ(pair.move().parted.size(), 1u);
  const EnergyBalance e = pair.energy();
  EXPECT_LT(std::abs(e.residual), 1e-3 * e.external);
  EXPECT_GE(e.friction, 0.0);
  EXPECT_NEAR(e.friction + e.fracture + e.contact + e.joint, e.external, 1e-2 * e.external);
  EXPECT_GT(e.fracture, 100.0 * JointPair::length);
}

}  // namespace
}  // namespace percolith::mechanics
