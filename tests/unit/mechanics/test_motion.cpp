// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/strain.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "unit/support/solid_model.hpp"

namespace percolith::mechanics {
namespace {

using test::at;

const test::Grid grid{.columns = 5, .rows = 4, .jitter = 0.2, .seed = 3, .mixed_diagonals = true};

bool on_boundary(Point p) {
  return p.x == 0.0 || p.x == 1.0 || p.y == 0.0 || p.y == 1.0;
}

/// A velocity of each corner at random, the same for the corners of a node.
void shake(Model& model, double speed, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-speed, speed);
  test::for_each_corner(model.mesh, [&](Index, Index c) {
    model.motion.vx[at(c)] = value(random);
    model.motion.vy[at(c)] = value(random);
  });
  for (Index c = 0; c < model.mesh.corners(); ++c) {
    model.motion.vx[at(c)] = model.motion.vx[at(model.nodes.leader(c))];
    model.motion.vy[at(c)] = model.motion.vy[at(model.nodes.leader(c))];
  }
}

TEST(Motion, TiedNodesPassThePatchTest) {
  // The boundary moves by a linear field, slowly enough to come to rest: so does everything.
  const Point dx{2e-6, 1e-6};
  const Point dy{-3e-6, 4e-6};
  const auto field = [&](Point p) { return p.x * dx + p.y * dy; };
  Model model = test::make_solid(test::make_grid(grid),
                                 {.joints = JointState::tied, .damping = {.nodal_viscosity = 4e6}});
  std::vector<PrescribedMotion> motions;
  std::vector<Held> held;
  test::for_each_corner(model.mesh, [&](Index, Index c) {
    const Point p = model.mesh.place_of(c);
    if (on_boundary(p)) {
      for (const Point direction : {Point{1.0, 0.0}, Point{0.0, 1.0}}) {
        held.push_back({c, direction, static_cast<Index>(motions.size())});
        motions.push_back({"edge",
                           PrescribedMotion::Kind::displacement,
                           {{0.0, 1e-4}, {0.0, dot(field(p), direction)}}});
      }
    }
  });
  SupportSet supports(model, motions, held);
  Dynamics dynamics = test::make_dynamics(std::move(model), {}, std::move(supports));
  const double dt = 1e-4 / std::ceil(1e-4 / (0.9 * test::stable_step(dynamics)));
  test::advance(dynamics, dt, 4000);
  const Tensor stress = triangle_stress(dynamics.model(), 0).plane;
  EXPECT_NEAR(stress.xx, 12e9 * 2e-6 + 4e9 * 4e-6, 1.0);
  test::for_each_corner(dynamics.model().mesh, [&](Index t, Index c) {
    const Point expected = field(dynamics.model().mesh.place_of(c));
    EXPECT_NEAR(test::displacement(dynamics.model(), c).x, expected.x, 1e-12 * 1e-3);
    EXPECT_NEAR(test::displacement(dynamics.model(), c).y, expected.y, 1e-12 * 1e-3);
    EXPECT_NEAR(triangle_stress(dynamics.model(), t).plane.xy, stress.xy, 1e-3);
  });
}

TEST(Motion, ARockAtRestStaysThere) {
  for (const JointState joints : {JointState::tied, JointState::bonded, JointState::closed}) {
    Dynamics dynamics =
        test::make_dynamics(test::make_solid(test::make_grid(grid), {.joints = joints}));
    test::advance(dynamics, test::stable_step(dynamics), 20);
    for (const double u : dynamics.model().motion.ux) {
      EXPECT_EQ(u, 0.0);
    }
    EXPECT_EQ(dynamics.unbalanced_ratio(), 0.0);
  }
}

TEST(Motion, FreeFallIsExact) {
  // Velocity first, then displacement, starting with half a step: y = -g t^2/2 at every step.
  for (const JointState joints : {JointState::tied, JointState::bonded}) {
    Dynamics dynamics = test::make_dynamics(
        test::make_solid(test::make_grid(grid), {.joints = joints, .gravity = 9.81}));
    const double dt = 0.5 * test::stable_step(dynamics);
    test::advance(dynamics, dt, 200);
    const double t = 200 * dt;
    test::for_each_corner(dynamics.model().mesh, [&](Index, Index c) {
      EXPECT_NEAR(dynamics.model().motion.uy[at(c)], -0.5 * 9.81 * t * t, 1e-12 * t * t);
      EXPECT_NEAR(dynamics.model().motion.ux[at(c)], 0.0, 1e-14);
    });
    EXPECT_NEAR(dynamics.model().motion.time, t, 1e-15);
    const EnergyBalance e = dynamics.energy(Execution());
    const double mass = 2500.0;
    // All energies are those half a step ago.
    EXPECT_NEAR(e.kinetic, 0.5 * mass * std::pow(9.81 * (t - 0.5 * dt), 2), 1e-9 * e.kinetic);
    EXPECT_NEAR(e.gravity, e.kinetic, 1e-9 * e.kinetic);
    EXPECT_GT(e.gravity, 0.0);
    EXPECT_NEAR(e.residual, 0.0, 1e-9 * e.gravity);
  }
}

TEST(Motion, MomentumStaysWithoutForcesFromOutside) {
  for (const JointState joints : {JointState::tied, JointState::bonded}) {
    Model model = test::make_solid(
        test::make_grid(grid), {.kind = test::joint_kind(1e6, 2e6, 5.0, 9.0), .joints = joints});
    shake(model, 1.0);
    const Point before = test::momentum(model);
    Dynamics dynamics = test::make_dynamics(std::move(model));
    test::advance(dynamics, 0.8 * test::stable_step(dynamics), 300);
    const Point after = test::momentum(dynamics.model());
    EXPECT_NEAR(after.x, before.x, 1e-12 * 2500.0);
    EXPECT_NEAR(after.y, before.y, 1e-12 * 2500.0);
  }
}

TEST(Motion, NodePassesGiveWhatTheSinglePassGives) {
  // Corners that share no nodes, moved as if they did.
  Model model =
      test::make_solid(test::make_grid(grid), {.kind = test::joint_kind(1e6, 2e6, 5.0, 9.0),
                                               .gravity = 9.81,
                                               .damping = {1e5, 0.1},
                                               .viscosity = 1e4});
  shake(model, 0.1);
  Model other = model;
  other.any_tied = true;
  const auto start = [](Model m) {
    SupportSet supports;
    std::vector<Held> held;
    test::hold_where(
        m, [](Point p) { return p.x == 0.0; }, {0.6, 0.8}, 0, held);
    supports =
        SupportSet(m, {{"left", PrescribedMotion::Kind::velocity, Schedule::constant(0.02)}}, held);
    LoadList loads;
    loads.traction.push_back(
        {test::edges_of(m, "right"), Schedule::constant(1e5), Schedule::constant(-2e5)});
    return test::make_dynamics(std::move(m), std::move(loads), std::move(supports));
  };
  Dynamics one = start(std::move(model));
  Dynamics three = start(std::move(other));
  const double dt = 0.5 * test::stable_step(one);
  for (int i = 0; i < 50; ++i) {
    test::advance(one, dt, 1);
    test::advance(three, dt, 1);
  }
  double largest = 0.0;
  for (const double u : one.model().motion.ux) {
    largest = std::max(largest, std::abs(u));
  }
  for (std::size_t c = 0; c < one.model().motion.ux.size(); ++c) {
    EXPECT_NEAR(one.model().motion.ux[c], three.model().motion.ux[c], 1e-9 * largest);
    EXPECT_NEAR(one.model().motion.uy[c], three.model().motion.uy[c], 1e-9 * largest);
  }
  const EnergyBalance a = one.energy(Execution());
  const EnergyBalance b = three.energy(Execution());
  for (double EnergyBalance::*const term :
       {&EnergyBalance::kinetic, &EnergyBalance::elastic, &EnergyBalance::joint,
        &EnergyBalance::fracture, &EnergyBalance::damping, &EnergyBalance::gravity,
        &EnergyBalance::external}) {
    EXPECT_NEAR(a.*term, b.*term, 1e-9 * (a.kinetic + a.elastic + a.damping));
  }
  EXPECT_NEAR(one.supports().reactions(one.model())[0].x,
              three.supports().reactions(three.model())[0].x, 1e-6 * 1e5);
  EXPECT_NEAR(one.unbalanced_ratio(), three.unbalanced_ratio(), 1e-6);
}

TEST(Motion, NodalViscositySlowsAsTheStepSays) {
  // Free corners of mass m: v' = v/(1 + mu dt/m) at each step, the first of half the length.
  Model model = test::make_solid(test::make_grid({.columns = 1, .rows = 1}),
                                 {.damping = {.nodal_viscosity = 3e6}});
  test::set_velocity(model, [](Point) { return Point{2.0, -1.0}; });
  const double mass = 2500.0 * 0.5 / 3.0;
  Dynamics dynamics = test::make_dynamics(std::move(model));
  const double dt = 1e-5;
  double expected = 2.0 / (1 + 3e6 * 0.5 * dt / mass);
  test::advance(dynamics, dt, 1);
  EXPECT_NEAR(dynamics.model().motion.vx[0], expected, 1e-14);
  for (int i = 0; i < 20; ++i) {
    expected /= 1 + 3e6 * dt / mass;
  }
  test::advance(dynamics, dt, 20);
  EXPECT_NEAR(dynamics.model().motion.vx[0], expected, 1e-13);
  const EnergyBalance e = dynamics.energy(Execution());
  EXPECT_GT(e.damping, 0.9 * 0.5 * 2500.0 * 5.0);
  EXPECT_NEAR(e.residual, 0.0, 1e-9 * e.damping);
}

TEST(Motion, LocalDampingTakesAShareOfTheUnbalancedForce) {
  // Falling, every corner feels (1 - a) g, thrown upwards (1 + a) g.
  for (const double up : {0.0, 5.0}) {
    Model model = test::make_solid(test::make_grid({.columns = 1, .rows = 1}),
                                   {.gravity = 10.0, .damping = {.local = 0.3}});
    test::set_velocity(model, [&](Point) { return Point{0.0, up}; });
    Dynamics dynamics = test::make_dynamics(std::move(model));
    const double dt = 1e-6;
    // At the very first step nothing moves yet and nothing is damped.
    test::advance(dynamics, dt, 1);
    const double first = dynamics.model().motion.vy[0];
    test::advance(dynamics, dt, 10);
    EXPECT_NEAR((dynamics.model().motion.vy[0] - first) / (10 * dt), up > 0.0 ? -13.0 : -7.0, 1e-6);
  }
}

TEST(Motion, LocalDampingLeavesAloneWhatASupportTakes) {
  // Gravity presses on rollers and pushes nothing along them: a glide is not slowed down.
  Model model = test::make_solid(test::make_grid({.columns = 1, .rows = 1}),
                                 {.gravity = 10.0, .damping = {.local = 0.8}});
  test::set_velocity(model, [](Point) { return Point{2.0, 0.0}; });
  std::vector<Held> held;
  test::hold_where(
      model, [](Point) { return true; }, {0.0, 1.0}, 0, held);
  SupportSet supports(model, {{"floor", PrescribedMotion::Kind::velocity, Schedule{}}}, held);
  Dynamics dynamics = test::make_dynamics(std::move(model), {}, std::move(supports));
  test::advance(dynamics, 1e-6, 50);
  test::for_each_corner(dynamics.model().mesh, [&](Index, Index c) {
    EXPECT_NEAR(dynamics.model().motion.vx[at(c)], 2.0, 1e-12);
  });
  EXPECT_EQ(dynamics.energy(Execution()).damping, 0.0);
}

TEST(Motion, ARemovedOrHeldCornerDoesNotCountAsUnbalanced) {
  Model model = test::make_solid(test::make_grid({.columns = 1, .rows = 1}), {.gravity = 10.0});
  std::vector<Held> held;
  for (const Point direction : {Point{1.0, 0.0}, Point{0.0, 1.0}}) {
    test::hold_where(
        model, [](Point) { return true; }, direction, 0, held);
  }
  SupportSet supports(model, {{"all", PrescribedMotion::Kind::velocity, Schedule{}}}, held);
  Dynamics dynamics = test::make_dynamics(std::move(model), {}, std::move(supports));
  test::advance(dynamics, 1e-6, 3);
  EXPECT_EQ(dynamics.unbalanced_ratio(), 0.0);
  EXPECT_NEAR(dynamics.supports().reactions(dynamics.model())[0].y, 2500.0 * 10.0, 1e-8);
}

}  // namespace
}  // namespace percolith::mechanics
