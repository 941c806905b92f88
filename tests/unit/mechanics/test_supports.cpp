// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/error.hpp"
#include "percolith/mechanics/strain.hpp"
#include "percolith/mechanics/supports.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "unit/support/setup.hpp"
#include "unit/support/solid_model.hpp"

namespace percolith::mechanics {
namespace {

using test::at;
using Kind = PrescribedMotion::Kind;

const test::Grid grid{.columns = 4, .rows = 4};

bool everywhere(Point) {
  return true;
}
bool at_left(Point p) {
  return p.x == 0.0;
}

TEST(Supports, ARollerOnAnInclineLeavesTheWayAlongIt) {
  // A frictionless slope of 30 degrees: the rock slides with g sin(30).
  const Point normal{-std::sin(std::numbers::pi / 6), std::cos(std::numbers::pi / 6)};
  for (const JointState joints : {JointState::tied, JointState::bonded}) {
    Model model = test::make_solid(test::make_grid(grid), {.joints = joints, .gravity = 9.81});
    std::vector<Held> held;
    test::hold_where(model, everywhere, normal, 0, held);
    SupportSet supports(model, {{"slope", Kind::velocity, Schedule{}}}, held);
    Dynamics dynamics = test::make_dynamics(std::move(model), {}, std::move(supports));
    const double dt = 0.5 * test::stable_step(dynamics);
    test::advance(dynamics, dt, 100);
    const double way = 0.5 * 9.81 * 0.5 * std::pow(100 * dt, 2);
    test::for_each_corner(dynamics.model().mesh, [&](Index, Index c) {
      const Point u = test::displacement(dynamics.model(), c);
      EXPECT_NEAR(dot(u, normal), 0.0, 1e-12 * way);
      EXPECT_NEAR(cross(normal, u), way, 1e-9 * way);
    });
    const Point reaction = dynamics.supports().reactions(dynamics.model())[0];
    const double weight = 2500.0 * 9.81 * std::cos(std::numbers::pi / 6);
    EXPECT_NEAR(dot(reaction, normal), weight, 1e-9 * weight);
    EXPECT_NEAR(cross(reaction, normal), 0.0, 1e-9 * weight);
  }
}

TEST(Supports, TwoDirectionsAskewMoveAsBothSay) {
  const Point a{1.0, 0.0};
  const Point b{std::sqrt(0.5), std::sqrt(0.5)};
  Model model = test::make_solid(test::make_grid(grid));
  std::vector<Held> held;
  test::hold_where(model, everywhere, a, 0, held);
  test::hold_where(model, everywhere, b, 1, held);
  SupportSet supports(model,
                      {{"a", Kind::velocity, Schedule::constant(0.3)},
                       {"b", Kind::velocity, Schedule::constant(-0.1)}},
                      held);
  Dynamics dynamics = test::make_dynamics(std::move(model), {}, std::move(supports));
  test::advance(dynamics, 1e-6, 7);
  test::for_each_corner(dynamics.model().mesh, [&](Index, Index c) {
    const Point v{dynamics.model().motion.vx[at(c)], dynamics.model().motion.vy[at(c)]};
    EXPECT_NEAR(dot(v, a), 0.3, 1e-14);
    EXPECT_NEAR(dot(v, b), -0.1, 1e-14);
  });
}

TEST(Supports, ADisplacementScheduleIsReachedExactly) {
  const Schedule way{{0.0, 1e-4, 2e-4}, {0.0, 3e-6, -1e-6}};
  Model model = test::make_solid(test::make_grid(grid));
  std::vector<Held> held;
  test::hold_where(model, at_left, {0.0, 1.0}, 0, held);
  SupportSet supports(model, {{"left", Kind::displacement, way}}, held);
  EXPECT_EQ(supports.next_break(0.0), 1e-4);
  EXPECT_EQ(supports.next_break(1e-4), 2e-4);
  Dynamics dynamics = test::make_dynamics(std::move(model), {}, std::move(supports));
  const double dt = 1e-4 / 100;
  ASSERT_LT(dt, test::stable_step(dynamics));
  for (int i = 0; i < 250; ++i) {
    test::advance(dynamics, dt, 1);
    const double now = dynamics.model().motion.time;
    EXPECT_NEAR(test::displacement_at(dynamics.model(), {0.0, 0.5}).y, way.at(now), 1e-18);
    EXPECT_NEAR(dynamics.supports().displacements(dynamics.model())[0].y, way.at(now), 1e-18);
  }
}

TEST(Supports, ReactionsEqualTheLoadAtEquilibrium) {
  for (const JointState joints : {JointState::tied, JointState::bonded}) {
    Model model = test::make_solid(test::make_grid(grid),
                                   {.joints = joints, .damping = {.nodal_viscosity = 1e5}});
    LoadList loads;
    loads.traction.push_back(
        {test::edges_of(model, "right"), Schedule::constant(2e6), Schedule::constant(-3e5)});
    std::vector<Held> held;
    for (const Point direction : {Point{1.0, 0.0}, Point{0.0, 1.0}}) {
      test::hold_where(model, at_left, direction, 0, held);
    }
    SupportSet supports(model, {{"left", Kind::velocity, Schedule{}}}, held);
    Dynamics dynamics =
        test::make_dynamics(std::move(model), std::move(loads), std::move(supports));
    test::advance(dynamics, 0.9 * test::stable_step(dynamics), 12000);
    const Point reaction = dynamics.supports().reactions(dynamics.model())[0];
    EXPECT_NEAR(reaction.x, -2e6, 2.0);
    EXPECT_NEAR(reaction.y, 3e5, 2.0);
    EXPECT_LT(dynamics.unbalanced_ratio(), 1e-5);
  }
}

TEST(Supports, ReactionsOfATableCountItsCornersOnce) {
  Model model = test::make_solid(test::make_grid({.columns = 1, .rows = 1}), {.gravity = 8.0});
  std::vector<Held> held;
  test::hold_where(
      model, [](Point p) { return p.y == 0.0; }, {0.0, 1.0}, 0, held);
  test::hold_where(
      model, [](Point p) { return p.y == 1.0; }, {0.0, 1.0}, 1, held);
  SupportSet supports(
      model, {{"bottom", Kind::velocity, Schedule{}}, {"top", Kind::velocity, Schedule{}}}, held);
  ASSERT_EQ(supports.tables(), (std::vector<std::string>{"bottom", "top"}));
  Dynamics dynamics = test::make_dynamics(std::move(model), {}, std::move(supports));
  test::advance(dynamics, 1e-6, 2);
  const auto reaction = dynamics.supports().reactions(dynamics.model());
  // Each of the six corners carries a sixth of the weight.
  EXPECT_NEAR(reaction[0].y, 0.5 * 2500.0 * 8.0, 1e-6);
  EXPECT_NEAR(reaction[1].y, 0.5 * 2500.0 * 8.0, 1e-6);
}

TEST(Supports, ARigidBodyKeepsItsShapeWhateverItIsPressedWith) {
  Model model = test::make_solid(test::make_grid(grid), {.joints = JointState::rigid});
  LoadList loads;
  loads.traction.push_back(
      {test::edges_of(model, "top"), Schedule::constant(0.0), Schedule::constant(-1e9)});
  std::vector<Held> held;
  test::hold_where(model, everywhere, {1.0, 0.0}, 0, held);
  test::hold_where(model, everywhere, {0.0, 1.0}, 1, held);
  SupportSet supports(model,
                      {{"body", Kind::velocity, Schedule{{0.0, 1e-3}, {0.0, 4.0}}},
                       {"body", Kind::velocity, Schedule::constant(-2.0)}},
                      held);
  Dynamics dynamics = test::make_dynamics(std::move(model), std::move(loads), std::move(supports));
  for (int i = 0; i < 100; ++i) {
    test::advance(dynamics, 1e-5, 1);
  }
  test::for_each_corner(dynamics.model().mesh, [&](Index t, Index c) {
    EXPECT_NEAR(test::displacement(dynamics.model(), c).x, 0.5 * 4.0 * 1e-3, 1e-15);
    EXPECT_NEAR(test::displacement(dynamics.model(), c).y, -2.0 * 1e-3, 1e-15);
    EXPECT_NEAR(triangle_stress(dynamics.model(), t).plane.yy, 0.0, 1.0);
  });
  EXPECT_NEAR(dynamics.supports().reactions(dynamics.model())[0].y, 1e9, 1e-3 * 1e9);
}

TEST(Supports, WhatHoldsACornerHoldsItsNode) {
  Model model =
      test::make_solid(test::make_grid(grid), {.joints = JointState::tied, .gravity = 9.81});
  const auto fan = model.mesh.vertex_corners.row(test::vertex_at(model.mesh, {0.5, 0.5}));
  ASSERT_GT(fan.size(), 1u);
  const Index last = fan.back();
  SupportSet supports(model, {{"nail", Kind::velocity, Schedule{}}},
                      std::vector<Held>{{last, {1.0, 0.0}, 0}, {last, {0.0, 1.0}, 0}});
  Dynamics dynamics = test::make_dynamics(std::move(model), {}, std::move(supports));
  test::advance(dynamics, 0.5 * test::stable_step(dynamics), 50);
  EXPECT_EQ(test::displacement_at(dynamics.model(), {0.5, 0.5}).y, 0.0);
  EXPECT_LT(test::displacement_at(dynamics.model(), {0.0, 0.0}).y, 0.0);
  EXPECT_GT(dynamics.supports().reactions(dynamics.model())[0].y, 0.0);
}

/// Supports of the corners at the left with the given motions along the given directions.
void build(const std::vector<PrescribedMotion>& motions, const std::vector<Point>& directions) {
  Model model = test::make_solid(test::make_grid(grid));
  std::vector<Held> held;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    test::hold_where(model, at_left, directions[i], static_cast<Index>(i), held);
  }
  const SupportSet supports(model, motions, held);
}

TEST(Supports, TwoMotionsAlongOneDirectionAreRefused) {
  test::expect_input_error(
      [] {
        build({{"boundary.a", Kind::velocity, Schedule::constant(1.0)},
               {"boundary.b", Kind::velocity, Schedule{}}},
              {{1.0, 0.0}, {-1.0, 0.0}});
      },
      "boundary.b", "is over-constrained: boundary.a prescribes another motion there");
}

TEST(Supports, ThreeDirectionsThatMoveAreRefused) {
  test::expect_input_error(
      [] {
        build({{"boundary.a", Kind::velocity, Schedule{}},
               {"boundary.b", Kind::velocity, Schedule{}},
               {"boundary.c", Kind::velocity, Schedule::constant(1.0)}},
              {{1.0, 0.0}, {0.0, 1.0}, {0.6, 0.8}});
      },
      "boundary.c", "at each point two independent directions at the most");
}

TEST(Supports, AgreeingMotionsAreAccepted) {
  EXPECT_NO_THROW(build({{"a", Kind::velocity, Schedule{}},
                         {"b", Kind::displacement, Schedule::constant(0.0)},
                         {"c", Kind::velocity, Schedule{}},
                         {"d", Kind::velocity, Schedule{}}},
                        {{1.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {0.6, 0.8}}));
  EXPECT_NO_THROW(build({{"a", Kind::velocity, Schedule::constant(1.0)},
                         {"b", Kind::velocity, Schedule::constant(1.0)}},
                        {{1.0, 0.0}, {1.0, 0.0}}));
}

}  // namespace
}  // namespace percolith::mechanics
