// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/step_limit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "unit/support/solid_model.hpp"

namespace percolith::mechanics {
namespace {

using test::at;

const test::Grid grid{.columns = 5, .rows = 5, .jitter = 0.25, .seed = 8, .mixed_diagonals = true};

Model shaken(const test::SolidOptions& options) {
  Model model = test::make_solid(test::make_grid(grid), options);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> value(-1e-6, 1e-6);
  for (Index c = 0; c < model.mesh.corners(); ++c) {
    model.motion.vx[at(c)] = value(random);
    model.motion.vy[at(c)] = value(random);
  }
  for (Index c = 0; c < model.mesh.corners(); ++c) {
    model.motion.vx[at(c)] = model.motion.vx[at(model.nodes.leader(c))];
    model.motion.vy[at(c)] = model.motion.vy[at(model.nodes.leader(c))];
  }
  return model;
}

/// Whether the energy stays within bounds over a few hundred steps.
bool is_stable(const test::SolidOptions& options, double dt) {
  Dynamics dynamics = test::make_dynamics(shaken(options));
  const double start = dynamics.energy(Execution()).kinetic;
  test::advance(dynamics, dt, 600);
  const double end = dynamics.energy(Execution()).kinetic;
  return std::isfinite(end) && end < 100.0 * start;
}

/// Limit of the step without contact, which nothing here touches.
double limit_of(const test::SolidOptions& options) {
  return step_limits(shaken(options), {}).back().step;
}

/// The longest stable step over the limit.
double slack(const test::SolidOptions& options) {
  const double limit = limit_of(options);
  double low = 1.0;
  double high = 8.0;
  for (int i = 0; i < 7; ++i) {
    const double middle = std::sqrt(low * high);
    (is_stable(options, middle * limit) ? low : high) = middle;
  }
  return low;
}

TEST(StepLimit, IsStableAndNotMuchTooStrict) {
  for (const JointState joints : {JointState::tied, JointState::bonded}) {
    for (const double viscosity : {0.0, 0.3}) {
      const test::SolidOptions options{.joints = joints, .viscosity_ratio = viscosity};
      EXPECT_TRUE(is_stable(options, 0.99 * limit_of(options)));
      const double found = slack(options);
      EXPECT_LT(found, 3.0);
      EXPECT_FALSE(is_stable(options, 2.0 * found * limit_of(options)));
    }
  }
}

TEST(StepLimit, OneTriangleAloneIsSharp) {
  const mesh::GmshMesh file = [] {
    mesh::GmshMesh one;
    one.file = "one.msh";
    one.regions = {"rock"};
    one.points = {{0.0, 0.0}, {1.0, 0.1}, {0.3, 0.8}};
    one.triangles = {{0, 1, 2}};
    one.triangle_region = {0};
    return one;
  }();
  const auto energy = [&](double share, double local_damping = 0.0) {
    Model model = test::make_solid(file, {.damping = {.local = local_damping}});
    test::set_velocity(model, [](Point p) { return Point{1e-3 * p.x, -2e-3 * p.y}; });
    const double limit = step_limits(model, {}).back().step;
    Dynamics dynamics = test::make_dynamics(std::move(model));
    test::advance(dynamics, share * limit, 2000);
    const EnergyBalance e = dynamics.energy(Execution());
    return e.kinetic;
  };
  EXPECT_LT(energy(0.99), 1.0);
  EXPECT_FALSE(energy(1.02) < 1e3);
  // Local damping goes by the last velocity: it makes the fastest mode stiffer, not calmer.
  EXPECT_LT(energy(0.99, 0.8), 1e-9);
  EXPECT_FALSE(energy(1.05, 0.8) < 1e3);
}

TEST(StepLimit, RootOfTheQuadratic) {
  EXPECT_DOUBLE_EQ(stable_step(4.0, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(stable_step(0.0, 8.0), 0.25);
  for (const double viscous : {0.1, 3.0, 1e9}) {
    const double dt = stable_step(4.0, viscous);
    EXPECT_NEAR(dt * dt * 4.0 + 2 * dt * viscous, 4.0, 1e-9);
  }
  EXPECT_TRUE(std::isinf(stable_step(0.0, 0.0)));
}

TEST(StepLimit, NamesWhatRulesAndWhere) {
  Model model =
      test::make_solid(test::make_grid({.columns = 2, .rows = 2}), {.viscosity_ratio = 0.5});
  const std::vector<double> penalty(at(model.mesh.triangles()), 1e9);
  const auto limits = step_limits(model, penalty);
  ASSERT_EQ(limits.size(), 5u);
  EXPECT_EQ(limits.back().mechanism, "all together");
  for (std::size_t i = 0; i + 1 < limits.size(); ++i) {
    EXPECT_LE(limits.back().step, limits[i].step);
    if (i > 0) {
      EXPECT_LE(limits[i - 1].step, limits[i].step);
    }
    EXPECT_NE(limits[i].triangle, mesh::none);
  }
  EXPECT_EQ(step_limits(test::make_solid(test::make_grid({.columns = 1, .rows = 1}),
                                         {.joints = JointState::tied}),
                        {})
                .front()
                .mechanism,
            "triangles");
}

TEST(StepLimit, ScalesWithSizeAndMass) {
  const double one = limit_of({});
  EXPECT_NEAR(limit_of({.rock = test::elastic_rock(10e9, 0.25, 10000.0)}), 2 * one, 1e-9 * one);
  EXPECT_NEAR(limit_of({.rock = test::elastic_rock(40e9)}), 0.5 * one, 1e-9 * one);
}

TEST(StepLimit, MassScalingReachesItsStep) {
  for (const double viscosity : {0.0, 0.4}) {
    Model model = shaken({.gravity = 9.81, .viscosity_ratio = viscosity});
    const double limit = step_limits(model, {}).back().step;
    const double weight = model.triangles.weight[0];
    const double added = scale_mass(model, {}, 2.0 * limit);
    EXPECT_GT(added, 0.0);
    EXPECT_NEAR(step_limits(model, {}).back().step, 2.0 * limit, 1e-9 * limit);
    EXPECT_EQ(model.triangles.weight[0], weight);
    EXPECT_EQ(scale_mass(model, {}, limit), 0.0);
  }
}

TEST(StepLimit, MassScalingTouchesOnlyWhatNeedsIt) {
  Model model = shaken({});
  const std::vector<double> before = model.triangles.inverse_mass;
  const double limit = step_limits(model, {}).back().step;
  double mass = 0.0;
  double more = 0.0;
  const double added = scale_mass(model, {}, 1.2 * limit);
  int kept = 0;
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    kept += before[at(t)] == model.triangles.inverse_mass[at(t)] ? 1 : 0;
    mass += 1.0 / before[at(t)];
    more += 1.0 / model.triangles.inverse_mass[at(t)];
  }
  EXPECT_GT(kept, 0);
  EXPECT_LT(kept, model.mesh.triangles());
  EXPECT_NEAR(added, more / mass - 1.0, 1e-12);
}

}  // namespace
}  // namespace percolith::mechanics
