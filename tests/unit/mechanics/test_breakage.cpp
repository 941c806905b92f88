// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/breakage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "unit/support/joint_pair.hpp"
#include "unit/support/solid_model.hpp"

namespace percolith::mechanics {
namespace {

using test::at;
using test::JointPair;

const JointKind brittle = test::joint_kind(3e6, 6e6, 50.0, 100.0);

TEST(Breakage, APulledJointBreaksInTensionAndSpendsItsEnergy) {
  JointPair pair(brittle, {{{1.1 * JointPair::opening_at_failure(brittle), 0.0}, 4000}});
  const auto broke = pair.move().broke;
  ASSERT_EQ(broke.size(), 1u);
  EXPECT_EQ(broke[0].joint, 0);
  EXPECT_EQ(broke[0].mode, Mode::tensile);
  EXPECT_NEAR(broke[0].length, JointPair::length, 1e-14);
  // It fails after 1/1.1 of the way.
  EXPECT_NEAR(broke[0].time, pair.model().motion.time / 1.1, 3 * JointPair::dt);
  EXPECT_EQ(pair.model().joints.state[0], JointState::broken);
  EXPECT_EQ(pair.model().bonded[0], 0);
  const EnergyBalance e = pair.energy();
  EXPECT_EQ(e.joint, 0.0);
  EXPECT_EQ(e.friction, 0.0);
  // What lies before the peak is spent too when the joint is gone: f_t^2/(2 k).
  const double before = 0.5 * std::pow(3e6, 2) / JointPair::stiffness() * JointPair::length;
  EXPECT_NEAR(broke[0].released, 50.0 * JointPair::length + before, 1e-4 * e.fracture);
  EXPECT_EQ(e.fracture, broke[0].released);
  EXPECT_LT(std::abs(e.residual), 1e-3 * e.external);
}

TEST(Breakage, ASlidJointBreaksInShear) {
  JointPair pair(brittle, {{{0.0, -1.1 * JointPair::slip_at_failure(brittle)}, 4000}});
  const auto broke = pair.move().broke;
  ASSERT_EQ(broke.size(), 1u);
  EXPECT_EQ(broke[0].mode, Mode::shear);
  const double before = 0.5 * std::pow(6e6, 2) / JointPair::stiffness() * JointPair::length;
  EXPECT_NEAR(broke[0].released, 100.0 * JointPair::length + before, 1e-2);
}

TEST(Breakage, OnAStraightMixedPathTheEventTellsWhatWasSpent) {
  // Straight to both peaks at once, and from there through both ranges alike.
  const Point peak{3e6 / JointPair::stiffness(), 6e6 / JointPair::stiffness()};
  const Point failure{JointPair::opening_at_failure(brittle), JointPair::slip_at_failure(brittle)};
  JointPair pair(brittle, {{peak, 1000}, {0.75 * (failure - peak), 4000}});
  EXPECT_TRUE(pair.move().broke.empty());
  const auto broke = pair.move().broke;
  ASSERT_EQ(broke.size(), 1u);
  EXPECT_EQ(broke[0].mode, Mode::mixed);
  const double before =
      0.5 * (std::pow(3e6, 2) + std::pow(6e6, 2)) / JointPair::stiffness() * JointPair::length;
  EXPECT_NEAR(broke[0].released, std::sqrt(0.5) * 150.0 * JointPair::length + before, 1e-3 * 150.0);
  EXPECT_EQ(pair.energy().fracture, broke[0].released);
}

TEST(Breakage, WithoutCohesionOnlyFrictionIsLeft) {
  const JointKind loose = test::joint_kind(3e6, 0.0, 50.0, 0.0, 0.6, 0.6);
  const double pressed = 5e6 / JointPair::stiffness();
  const double limit = 0.6 * 5e6 / JointPair::stiffness();
  JointPair pair(loose, {{{0.0, 0.9 * limit}, 100}, {{0.0, 2 * limit}, 100}}, pressed);
  EXPECT_TRUE(pair.move().broke.empty());
  const auto broke = pair.move().broke;
  ASSERT_EQ(broke.size(), 1u);
  EXPECT_EQ(broke[0].mode, Mode::shear);
  EXPECT_EQ(pair.model().joints.state[0], JointState::closed);
  EXPECT_NEAR(std::abs(pair.joint_force().y), 0.6 * 5e6 * JointPair::length, 1.0);
  EXPECT_LT(pair.energy().fracture, 0.02 * pair.energy().friction);
}

TEST(Breakage, WithoutTensileStrengthAnyPullOpens) {
  JointPair pair(test::joint_kind(0.0, 6e6, 0.0, 100.0), {{{1e-9, 0.0}, 10}});
  const auto broke = pair.move().broke;
  ASSERT_EQ(broke.size(), 1u);
  EXPECT_EQ(broke[0].mode, Mode::tensile);
  EXPECT_EQ(pair.joint_force().x, 0.0);
  EXPECT_EQ(broke[0].released, 0.0);
  EXPECT_EQ(pair.energy().fracture, 0.0);
}

TEST(Breakage, WhatIsSpentDoesNotDependOnTheSteps) {
  // Ten steps to the peak and a hundred past it, or a hundred times as many.
  const double way = 1.1 * JointPair::opening_at_failure(brittle);
  const auto spent = [&](int steps) {
    JointPair pair(brittle, {{{way, 0.0}, steps}});
    const auto broke = pair.move().broke;
    return broke.size() == 1 ? broke[0].released : 0.0;
  };
  const double exact = spent(40000);
  EXPECT_NEAR(spent(400), exact, 2e-3 * exact);
  EXPECT_NEAR(spent(100), exact, 0.02 * exact);
}

TEST(Breakage, AJointThatGapesAtOneEndIsGivenUp) {
  // One end opens far, the other stays together: the second point would never fail.
  Model model = test::make_solid(test::make_grid({.columns = 1, .rows = 1}), {.kind = brittle});
  const JointTable table = joint_table(model);
  const Point edge{model.joints.ex[0], model.joints.ey[0]};
  const Point across = (1.0 / JointPair::length) * clockwise(edge);
  const Index end = model.mesh.joint[0].corner[1][0];
  const auto open = [&](double share) {
    model.motion.ux[at(end)] = share * JointPair::length * across.x;
    model.motion.uy[at(end)] = share * JointPair::length * across.y;
    // The other end follows, so that its point keeps the opening of zero.
    const Index other = model.mesh.joint[0].corner[1][1];
    model.motion.ux[at(other)] = -0.268 * model.motion.ux[at(end)];
    model.motion.uy[at(other)] = -0.268 * model.motion.uy[at(end)];
    test::joint_forces_of(model);
    return break_failed_joints(model, table).broke.size();
  };
  EXPECT_EQ(open(0.05), 0u);
  EXPECT_EQ(open(0.2), 1u);
}

TEST(Breakage, APointThatFailedEarlyCountsByHowItFailed) {
  // Point 0 failed in pure shear and then opened, point 1 fails in pure shear.
  JointPair pair(brittle, {{{0.0, JointPair::slip_at_failure(brittle)}, 10}});
  Model model = pair.model();
  for (std::size_t g = 0; g < 2; ++g) {
    model.joints.damage[g][0] = 1.0;
    model.joints.slip_peak[g][0] = JointPair::slip_at_failure(brittle);
  }
  model.joints.opening_peak[0][0] = 1.0;
  model.joints.condition[0] = static_cast<std::uint8_t>(BlockCondition::failed);
  const auto broke = break_failed_joints(model, joint_table(model)).broke;
  ASSERT_EQ(broke.size(), 1u);
  EXPECT_EQ(broke[0].mode, Mode::mixed);
}

TEST(Breakage, ShortOfTheWayNothingBreaks) {
  JointPair pair(brittle, {{{0.95 * JointPair::opening_at_failure(brittle), 0.0}, 4000}});
  EXPECT_TRUE(pair.move().broke.empty());
  EXPECT_EQ(pair.model().joints.state[0], JointState::bonded);
  EXPECT_GT(pair.model().joints.damage[0][0], 0.9);
}

/// Breaks joints of a model by hand.
void fail(Model& model, const std::vector<Index>& joints) {
  for (const Index j : joints) {
    for (std::size_t g = 0; g < 2; ++g) {
      model.joints.damage[g][at(j)] = 1.0;
    }
    model.joints.condition[at(j / block_width)] = static_cast<std::uint8_t>(BlockCondition::failed);
  }
}

const test::Grid grid{.columns = 6, .rows = 6, .jitter = 0.2, .mixed_diagonals = true};

TEST(Breakage, FansDoNotDependOnTheOrderInWhichJointsBreak) {
  Model together = test::make_solid(test::make_grid(grid));
  Model one_by_one = together;
  const JointTable table = joint_table(together);
  std::vector<Index> joints(at(together.mesh.joints()));
  std::iota(joints.begin(), joints.end(), 0);
  std::shuffle(joints.begin(), joints.end(), std::mt19937(5));
  joints.resize(joints.size() / 2);
  fail(together, joints);
  const Changes changes = break_failed_joints(together, table);
  EXPECT_EQ(changes.broke.size(), joints.size());
  EXPECT_TRUE(std::is_sorted(changes.broke.begin(), changes.broke.end(),
                             [](const auto& a, const auto& b) { return a.joint < b.joint; }));
  for (const Index j : joints) {
    fail(one_by_one, {j});
    ASSERT_EQ(break_failed_joints(one_by_one, table).broke.size(), 1u);
  }
  const mesh::NodeMap rebuilt(together.mesh, together.bonded);
  for (Index c = 0; c < together.mesh.corners(); ++c) {
    EXPECT_EQ(together.fans.leader(c), one_by_one.fans.leader(c));
    EXPECT_EQ(together.fans.leader(c), rebuilt.leader(c));
  }
  EXPECT_EQ(find_fragments(together).number, find_fragments(one_by_one).number);
}

TEST(Breakage, ABrokenJointIsToldOnce) {
  Model model = test::make_solid(test::make_grid(grid));
  const JointTable table = joint_table(model);
  fail(model, {3, 9});
  EXPECT_EQ(break_failed_joints(model, table).broke.size(), 2u);
  fail(model, {4});
  const auto again = break_failed_joints(model, table).broke;
  ASSERT_EQ(again.size(), 1u);
  EXPECT_EQ(again[0].joint, 4);
  EXPECT_FALSE(break_failed_joints(model, table).any());
}

TEST(Breakage, AJointOfWhichOnePointHoldsIsNotBroken) {
  Model model = test::make_solid(test::make_grid(grid));
  fail(model, {3});
  model.joints.damage[1][3] = 0.999;
  EXPECT_FALSE(break_failed_joints(model, joint_table(model)).any());
}

TEST(Fragments, AreCountedWithTheirAreas) {
  mesh::GmshMesh file = test::make_grid({.columns = 4, .rows = 4});
  test::add_column_curve({.columns = 4, .rows = 4}, file, "cut", 1, 0, 4);
  Model model = test::make_solid(file, {.curves = {{"cut", JointState::closed}}});
  const Fragments two = find_fragments(model);
  ASSERT_EQ(two.area.size(), 2u);
  EXPECT_NEAR(two.area[0] + two.area[1], 1.0, 1e-14);
  EXPECT_NEAR(std::min(two.area[0], two.area[1]), 0.25, 1e-14);
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    const bool left = test::centroid(model.mesh, t).x < 0.25;
    EXPECT_NEAR(two.area[at(two.number[at(t)])], left ? 0.25 : 0.75, 1e-14);
  }
  EXPECT_EQ(find_fragments(test::make_solid(file)).area.size(), 1u);
  model.triangles.inverse_mass[5] = 0.0;  // taken out
  const Fragments less = find_fragments(model);
  EXPECT_EQ(less.number[5], mesh::none);
  EXPECT_NEAR(std::accumulate(less.area.begin(), less.area.end(), 0.0), 1.0 - 1.0 / 32, 1e-14);
}

/// Rock that flies apart: many joints break, some fragments meet again.
Model bursting(int cells) {
  Model model = test::make_solid(
      test::make_grid({.columns = cells, .rows = cells, .jitter = 0.2, .mixed_diagonals = true}),
      {.kind = test::joint_kind(1e6, 2e6, 5.0, 10.0)});
  test::set_velocity(model, [](Point p) {
    return Point{3.0 * (p.x - 0.5) + 2.0 * std::sin(9.0 * p.y), 3.0 * (p.y - 0.5)};
  });
  return model;
}

TEST(Breakage, EnergyOfABurstIsAccountedFor) {
  Dynamics dynamics = test::make_dynamics(bursting(6));
  const double start = dynamics.energy(Execution()).kinetic;
  const double dt = 0.1 * test::stable_step(dynamics);
  Execution execution;
  double told = 0.0;
  std::size_t broken = 0;
  double fracture = 0.0;
  for (int i = 0; i < 12000; ++i) {
    for (const Breakage& b : dynamics.advance(dt, execution).broke) {
      told += b.released;
      ++broken;
    }
    if (i % 1000 == 0) {
      const EnergyBalance e = dynamics.energy(execution);
      EXPECT_GE(e.fracture, fracture - 1e-4 * start);
      fracture = e.fracture;
    }
  }
  const EnergyBalance e = dynamics.energy(execution);
  EXPECT_GT(broken, 20u);
  EXPECT_LT(std::abs(e.residual), 1e-3 * start);
  EXPECT_NEAR(e.fracture, told, 0.15 * told);
  EXPECT_GE(e.friction, 0.0);
  EXPECT_GT(e.contact, -1e-3 * start);
  const Motion& m = dynamics.model().motion;
  const CornerMotion now{m.ux, m.uy, m.vx, m.vy};
  const double contact = dynamics.contact().potential_energy(dynamics.model().mesh, now) +
                         dynamics.contact().stored_tangential();
  EXPECT_NEAR(e.contact, contact, 5e-3 * start);
  const Fragments fragments = find_fragments(dynamics.model());
  EXPECT_GT(fragments.area.size(), 2u);
  EXPECT_NEAR(std::accumulate(fragments.area.begin(), fragments.area.end(), 0.0), 1.0, 1e-12);
}

TEST(Reproducible, TheSameBitsOnAnyBackendAndNumberOfThreads) {
  const auto hash = [](Execution execution, std::size_t& broken) {
    Dynamics dynamics = test::make_dynamics(bursting(48));  // loops long enough for threads
    const double dt = 0.8 * test::stable_step(dynamics);
    for (int i = 0; i < 150; ++i) {
      broken += dynamics.advance(dt, execution).broke.size();
    }
    return test::state_hash(dynamics);
  };
  std::size_t broken = 0;
  const std::string reference = hash(Execution(Backend::serial), broken);
  EXPECT_GT(broken, 50u);
  for (const int threads : {1, 1, 2, 3}) {
    std::size_t again = 0;
    EXPECT_EQ(hash(Execution(Backend::host, threads), again), reference) << threads;
    EXPECT_EQ(again, broken);
  }
}

TEST(Reproducible, TiedNodesToo) {
  const auto hash = [](Execution execution) {
    Model model = test::make_solid(
        test::make_grid({.columns = 48, .rows = 48, .jitter = 0.2, .mixed_diagonals = true}),
        {.joints = JointState::tied});
    test::set_velocity(model, [](Point p) { return Point{std::sin(9.0 * p.y), p.x * p.y}; });
    Dynamics dynamics = test::make_dynamics(std::move(model));
    const double dt = 0.8 * test::stable_step(dynamics);
    for (int i = 0; i < 50; ++i) {
      dynamics.advance(dt, execution);
    }
    return test::state_hash(dynamics);
  };
  const std::string reference = hash(Execution(Backend::serial));
  for (const int threads : {1, 2}) {
    EXPECT_EQ(hash(Execution(Backend::host, threads)), reference) << threads;
  }
}

TEST(Reproducible, TheHashSeesWhatJointsRemember) {
  Dynamics dynamics = test::make_dynamics(bursting(4));
  const std::string before = test::state_hash(dynamics);
  dynamics.model().joints.damage[1][2] = 1e-12;
  EXPECT_NE(test::state_hash(dynamics), before);
}

}  // namespace
}  // namespace percolith::mechanics
