// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/explicit_step.hpp"
#include "percolith/seepage/step_limit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "unit/support/flow_model.hpp"
#include "unit/support/implicit_steps.hpp"

namespace percolith::seepage {
namespace {

using std::numbers::pi;
using test::at;

/// k M/mu of the standard options, m2/s.
constexpr double diffusivity = 1e-13 * (2.2e9 / 0.2) / 1e-3;

/// Pressure p_0 at x = 0 from time zero on, nothing before and at x = 1.
double diffusion_series(double x, double t) {
  double sum = 1.0 - x;
  for (int n = 1; n < 200; ++n) {
    sum -= 2.0 / (n * pi) * std::sin(n * pi * x) * std::exp(-n * n * pi * pi * diffusivity * t);
  }
  return sum;
}

double error_against_series(int columns, int steps, double t) {
  Model model = test::make_flow(
      test::make_grid({.columns = columns, .rows = 2, .height = 2.0 / columns}), {});
  test::prescribe_pores(model, "left", 1e5, [](const Point& p) { return p.x == 0.0; });
  test::prescribe_pores(model, "right", 0.0, [](const Point& p) { return p.x == 1.0; });
  ImplicitFlow flow(model);
  test::advance_implicit(flow, model, t, t / steps);
  double error = 0.0;
  for (const Index c : test::corners_of(model.mesh)) {
    error = std::max(error, std::abs(model.state.pressure[at(c)] / 1e5 -
                                     diffusion_series(model.mesh.place_of(c).x, t)));
  }
  return error;
}

TEST(ImplicitFlow, FollowsTheDiffusionSeries) {
  EXPECT_LT(error_against_series(60, 1000, 0.05 / diffusivity), 1e-3);
  // In the end nothing is left but the straight line, however large the steps.
  EXPECT_LT(error_against_series(30, 4, 100.0 / diffusivity), 1e-5);
}

/// A sine over the strip decays by itself; returns the pressure in the middle over its start.
double decayed_sine(int steps) {
  test::FlowOptions options;
  options.fluid.cavitation_pressure = -test::infinity;
  Model model =
      test::make_flow(test::make_grid({.columns = 40, .rows = 2, .height = 0.05}), options);
  const auto ends = [](const Point& p) { return p.x == 0.0 || p.x == 1.0; };
  test::prescribe_pores(model, "ends", 0.0, ends);
  set_pores(model, [&](const Point& p) {
    return FluidState<double>{ends(p) ? 0.0 : 1e5 * std::sin(pi * p.x), 1.0};
  });
  const double t = 0.1 / diffusivity;
  ImplicitFlow flow(model);
  test::advance_implicit(flow, model, t, t / steps);
  return test::pore_pressure(model, {0.5, 0.025}) / 1e5;
}

TEST(ImplicitFlow, IsOfFirstOrderInTime) {
  // The rate of decay of this discrete sine: 2 (1 - cos(pi h))/h^2.
  const double h = 1.0 / 40;
  const double exact = std::exp(-0.1 * 2.0 * (1.0 - std::cos(pi * h)) / (h * h));
  const double coarse = decayed_sine(20) - exact;
  const double middle = decayed_sine(40) - exact;
  const double fine = decayed_sine(80) - exact;
  EXPECT_NEAR(coarse / middle, 2.0, 0.1);
  EXPECT_NEAR(middle / fine, 2.0, 0.05);
}

Model cracked_box(double exchange, PoreJoints joints = PoreJoints::tied) {
  const test::Grid grid{.columns = 8, .rows = 8, .jitter = 0.2, .mixed_diagonals = true};
  auto file = test::make_grid(grid);
  test::add_column_curve(grid, file, "crack", 4, 2, 8);
  test::add_row_curve(grid, file, "branch", 5, 2, 6);
  test::FlowOptions options;
  options.gravity = 9.81;
  options.joints = joints;
  options.fracture = {{.initial_aperture = 2e-5, .transmissivity = {}, .exchange = exchange}};
  Model model = test::make_flow(file, options);
  test::break_curve(model, "crack");
  test::break_curve(model, "branch");
  const auto state = [](const Point& p) {
    return FluidState<double>{1e6 * (1.0 + p.x + p.y * p.y), 1.0};
  };
  set_pores(model, state);
  set_cracks(model, state);
  test::prescribe_pores(
      model, "left", Schedule::constant(1e6), [](const Point& p) { return p.x == 0.0; },
      [](const Point& p) { return 1.0 + p.y; });
  test::inject_crack(model, "well", Schedule::constant(1e-6), {0.5, 0.75});
  test::inject_pores(model, "pump", Schedule::constant(-1e-7), {0.875, 0.125});
  return model;
}

TEST(ImplicitFlow, AgreesWithTheExplicitSchemeAtSmallSteps) {
  for (const PoreJoints joints : {PoreJoints::tied, PoreJoints::finite}) {
    Model explicit_model = cracked_box(1e-8, joints);
    const double dt = 0.5 * step_limits(make_flow_graph(explicit_model)).back().step;
    const int steps = 2000;
    ExplicitStep scheme(explicit_model);
    Execution execution;
    for (int i = 0; i < steps; ++i) {
      scheme.advance(explicit_model, dt, execution);
    }
    double before = 0.0;
    for (const int factor : {8, 4}) {
      Model model = cracked_box(1e-8, joints);
      ImplicitFlow flow(model);
      test::advance_implicit(flow, model, steps * dt, factor * dt);
      double error = 0.0;
      for (const Index c : test::corners_of(model.mesh)) {
        error = std::max(
            error, std::abs(model.state.pressure[at(c)] - explicit_model.state.pressure[at(c)]));
      }
      for (const Index v : model.cracks.open_nodes()) {
        error = std::max(error, std::abs(model.state.crack_pressure[at(v)] -
                                         explicit_model.state.crack_pressure[at(v)]));
      }
      EXPECT_LT(error, 2e-3 * 3e6);
      // The difference of the two schemes is of first order in the step: 9 against 5 parts.
      if (before > 0.0) {
        EXPECT_NEAR(error / before, 5.0 / 9.0, 0.1);
      }
      before = error;
    }
  }
}

TEST(ImplicitFlow, ConservesFluidWithStepsOfAnyLength) {
  for (const double exchange : {0.0, 1e-8, test::infinity}) {
    Model model = cracked_box(exchange);
    ImplicitFlow flow(model);
    const test::Balance balance(model);
    Execution execution;
    double time = 0.0;
    for (const double dt : {1e-9, 1e-6, 1e-3, 1.0, 1e-4, 1e3, 1e6, 1e-6}) {
      ASSERT_TRUE(flow.attempt(model, dt, execution));
      flow.accept(model);
      time += dt;
      EXPECT_LT(balance.error(model), 1e-14) << dt;
    }
    EXPECT_DOUBLE_EQ(model.state.time, time);
    EXPECT_NEAR(model.let_in[1].total(), 1e-6 * time, 1e-12 * 1e-6 * time);
    EXPECT_NEAR(model.let_in[2].total(), -1e-7 * time, 1e-12 * 1e-7 * time);
    EXPECT_NEAR(model.rate[1], 1e-6, 1e-18);
  }
}

TEST(ImplicitFlow, AnAttemptLeavesTheModelAlone) {
  Model model = cracked_box(1e-8);
  const State before = model.state;
  ImplicitFlow flow(model);
  Execution execution;
  ASSERT_TRUE(flow.attempt(model, 1.0, execution));
  EXPECT_EQ(model.state.pressure, before.pressure);
  EXPECT_EQ(model.state.content, before.content);
  EXPECT_EQ(model.state.time, 0.0);
  // A repeated attempt gives the same bits, also after another step in between.
  ASSERT_TRUE(flow.attempt(model, 0.1, execution));
  ASSERT_TRUE(flow.attempt(model, 1.0, execution));
  flow.accept(model);
  Model other = cracked_box(1e-8);
  ImplicitFlow fresh(other);
  ASSERT_TRUE(fresh.attempt(other, 1.0, execution));
  fresh.accept(other);
  EXPECT_EQ(model.state.pressure, other.state.pressure);
}

TEST(ImplicitFlow, InfiniteExchangeIsOnePressureForCrackAndFaces) {
  Model model = cracked_box(test::infinity);
  ImplicitFlow flow(model);
  test::advance_implicit(flow, model, 1.0, 0.01);
  for (const Index j : model.cracks.broken_joints()) {
    const auto& joint = model.mesh.joint[at(j)];
    for (std::size_t end = 0; end < 2; ++end) {
      const double crack = model.state.crack_pressure[at(joint.vertex[end])];
      for (std::size_t side = 0; side < 2; ++side) {
        EXPECT_NEAR(model.state.pressure[at(joint.corner[side][end])], crack, 1e-9 * crack);
      }
    }
  }
}

TEST(ImplicitFlow, LargeFiniteExchangeApproachesTheInfiniteOne) {
  Model limit = cracked_box(test::infinity);
  ImplicitFlow flow(limit);
  test::advance_implicit(flow, limit, 1.0, 0.01);
  double before = 0.0;
  for (const double exchange : {1e-7, 1e-6}) {
    Model model = cracked_box(exchange);
    ImplicitFlow finite(model);
    test::advance_implicit(finite, model, 1.0, 0.01);
    double error = 0.0;
    for (const Index c : test::corners_of(model.mesh)) {
      error = std::max(error, std::abs(model.state.pressure[at(c)] - limit.state.pressure[at(c)]));
    }
    if (before > 0.0) {
      EXPECT_NEAR(before / error, 10.0, 1.5);
    }
    before = error;
  }
}

TEST(ImplicitFlow, ASealedBoxFillsToContentOverStorage) {
  test::FlowOptions options;
  options.fracture = {{.initial_aperture = 2e-3, .transmissivity = {}, .exchange = 1e-8}};
  const test::Grid grid{.columns = 6, .rows = 6};
  auto file = test::make_grid(grid);
  test::add_column_curve(grid, file, "crack", 3, 1, 5);
  Model model = test::make_flow(file, options);
  test::break_curve(model, "crack");
  set_cracks(model, [](const Point&) { return FluidState<double>{0.0, 1.0}; });
  // On for two seconds, then off.
  test::inject_crack(model, "well", {{0.0, 2.0}, {1e-5, 0.0}, Interpolation::step}, {0.5, 0.5});
  ImplicitFlow flow(model);
  test::advance_implicit(flow, model, 2.0, 0.5);
  test::advance_implicit(flow, model, 3e4, 1e4);
  const double volume = 2e-3 * 4.0 / 6.0;
  const double storage = 0.2 / 2.2e9 + volume / 2.2e9;
  const double expected = 2e-5 / storage;
  for (const Index c : test::corners_of(model.mesh)) {
    EXPECT_NEAR(model.state.pressure[at(c)], expected, 1e-6 * expected);
  }
  EXPECT_NEAR(test::crack_pressure(model, {0.5, 0.5}), expected, 1e-6 * expected);
}

TEST(ImplicitFlow, APressureThatJumpsDoesNotActBeforeItsTime) {
  Model model = test::make_flow(test::make_grid({.columns = 10, .rows = 2}), {});
  test::prescribe_pores(
      model, "left", Schedule{{0.0, 5.0}, {0.0, 1e5}, Interpolation::step},
      [](const Point& p) { return p.x == 0.0; }, [](const Point&) { return 1.0; });
  ImplicitFlow flow(model);
  test::advance_implicit(flow, model, 5.0, 1.0);
  EXPECT_EQ(model.let_in[0].total(), 0.0);
  EXPECT_EQ(test::pore_pressure(model, {0.5, 0.5}), 0.0);
  test::advance_implicit(flow, model, 6.0, 1.0);
  EXPECT_GT(test::pore_pressure(model, {0.5, 0.5}), 0.0);
  EXPECT_EQ(test::pore_pressure(model, {0.0, 0.5}), 1e5);
}

}  // namespace
}  // namespace percolith::seepage
