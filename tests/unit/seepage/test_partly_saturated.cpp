// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/explicit_step.hpp"
#include "percolith/seepage/step_limit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "unit/support/flow_model.hpp"
#include "unit/support/implicit_steps.hpp"

namespace percolith::seepage {
namespace {

using test::at;

constexpr double round_off = 1e-12;

/// Everything full and at zero pressure, open at the bottom: the column drains by its weight.
Model full_column(SaturationWeight weight = SaturationWeight::upstream) {
  test::FlowOptions options;
  options.gravity = 9.81;
  options.weight = weight;
  options.fluid.bulk_modulus = 2.2e7;  // few explicit steps; the drainage hardly feels it
  Model model = test::make_flow(test::make_grid({.columns = 2,
                                                 .rows = 12,
                                                 .width = 0.5,
                                                 .height = 3.0,
                                                 .jitter = 0.15,
                                                 .mixed_diagonals = true}),
                                options);
  test::face_pores(model, "bottom", 0.0, [](const Point& p) { return p.y == 0.0; });
  return model;
}

/// Speed of a full column under its own weight, m/s.
constexpr double full_speed = 1e-13 * 9810.0 / 1e-3;

TEST(Drainage, ImplicitAndExplicitAgree) {
  const double end = 0.5 * 0.2 * 3.0 / full_speed;
  Model by_explicit = full_column();
  const test::Balance balance(by_explicit);
  ExplicitStep scheme(by_explicit);
  Execution execution;
  const double limit = 0.9 * step_limits(make_flow_graph(by_explicit)).back().step;
  const auto steps = static_cast<int>(std::ceil(end / limit));
  for (int i = 0; i < steps; ++i) {
    scheme.advance(by_explicit, end / steps, execution);
  }
  EXPECT_LT(balance.error(by_explicit), round_off);
  const auto range = test::saturation_range(by_explicit);
  EXPECT_GE(range.first, 0.0);
  EXPECT_LE(range.second, 1.0);
  EXPECT_LT(range.first, 0.6);

  Model by_implicit = full_column();
  const test::Balance implicit_balance(by_implicit);
  ImplicitFlow flow(by_implicit);
  test::advance_implicit(flow, by_implicit, end, end / 2000);
  EXPECT_LT(implicit_balance.error(by_implicit), round_off);
  EXPECT_GE(test::saturation_range(by_implicit).first, -1e-9);
  for (const Index c : test::corners_of(by_implicit.mesh)) {
    EXPECT_NEAR(by_implicit.state.saturation[at(c)], by_explicit.state.saturation[at(c)], 5e-3);
  }
  EXPECT_NEAR(by_implicit.let_in[0].total(), by_explicit.let_in[0].total(),
              5e-3 * std::abs(by_explicit.let_in[0].total()));
}

TEST(Drainage, BeginsAtTheSpeedOfAFullColumnAndNeverTakesFluidIn) {
  Model model = full_column();
  ImplicitFlow flow(model);
  Execution execution;
  const double dt = 1e-3 * 0.2 * 3.0 / full_speed;
  ASSERT_TRUE(flow.attempt(model, dt, execution));
  flow.accept(model);
  EXPECT_NEAR(model.rate[0], -0.5 * full_speed, 0.02 * 0.5 * full_speed);
  for (int i = 0; i < 200; ++i) {
    ASSERT_TRUE(flow.attempt(model, 10 * dt, execution));
    flow.accept(model);
    EXPECT_LE(model.rate[0], 1e-12 * full_speed);
  }
}

TEST(Drainage, ConvergesWithStepsOfAnyLength) {
  for (const double share : {0.01, 0.3, 3.0, 100.0}) {
    Model model = full_column();
    const test::Balance balance(model);
    ImplicitFlow flow(model);
    const double span = 0.2 * 3.0 / full_speed;
    EXPECT_LT(test::advance_implicit(flow, model, 4.0 * span, share * span), 5000) << share;
    EXPECT_LT(balance.error(model), round_off) << share;
    EXPECT_GE(test::saturation_range(model).first, -1e-9) << share;
  }
}

TEST(Drainage, TheMeanWeightConservesFluidToo) {
  Model model = full_column(SaturationWeight::mean);
  const test::Balance balance(model);
  ImplicitFlow flow(model);
  const double end = 0.1 * 0.2 * 3.0 / full_speed;
  test::advance_implicit(flow, model, end, end / 100);
  EXPECT_LT(balance.error(model), round_off);
  EXPECT_LT(test::saturation_range(model).first, 1.0);
}

/// A sealed crack of length 1 m and aperture 0.1 mm in impervious rock, empty, fed at its mouth.
double filled_length(int columns, double end, double* error, int* attempts) {
  const test::Grid grid{.columns = columns, .rows = 2, .height = 2.0 / columns};
  auto file = test::make_grid(grid);
  test::add_row_curve(grid, file, "crack", 1, 0, columns);
  test::FlowOptions options;
  options.rock.permeability = {1e-30, 1e-30, 0.0};
  options.fracture = {{.initial_aperture = 1e-4, .transmissivity = {}, .exchange = 0.0}};
  Model model = test::make_flow(file, options);
  test::break_curve(model, "crack");
  set_cracks(model, [](const Point&) { return FluidState<double>{0.0, 0.0}; });
  test::prescribe_crack(model, "mouth", Schedule::constant(1e5), {0.0, 1.0 / columns});
  ImplicitFlow flow(model);
  const test::Balance balance(model);
  *attempts = test::advance_implicit(flow, model, end, end / 400);
  *error = balance.error(model);
  double volume = 0.0;
  for (const Index v : model.cracks.open_nodes()) {
    volume += model.state.crack_saturation[at(v)] * model.crack.void_volume[at(v)];
  }
  return volume / 1e-4;
}

TEST(Filling, TheFrontMovesWithTheRootOfTime) {
  for (const int columns : {20, 40, 80}) {
    for (const double end : {0.5, 2.0, 4.0}) {
      double error = 1.0;
      int attempts = 0;
      const double length = filled_length(columns, end, &error, &attempts);
      // x_f = a sqrt(P t/(6 mu))
      const double expected = 1e-4 * std::sqrt(1e5 * end / (6.0 * 1e-3));
      EXPECT_NEAR(length, expected, (0.02 + 1.0 / columns) * expected) << columns << ' ' << end;
      EXPECT_LT(error, round_off);
      EXPECT_LT(attempts, 2000);
    }
  }
}

TEST(Filling, ExplicitAndImplicitFillAlike) {
  const test::Grid grid{.columns = 10, .rows = 4, .height = 0.4};
  auto file = test::make_grid(grid);
  test::add_row_curve(grid, file, "crack", 2, 0, 8);
  test::FlowOptions options;
  options.gravity = 9.81;
  options.fluid.bulk_modulus = 2.2e6;
  options.fracture = {{.initial_aperture = 2e-5, .transmissivity = {}, .exchange = 1e-8}};
  const auto make = [&] {
    Model model = test::make_flow(file, options);
    test::break_curve(model, "crack");
    set_pores(model, [](const Point&) { return FluidState<double>{0.0, 0.3}; });
    set_cracks(model, [](const Point&) { return FluidState<double>{0.0, 0.1}; });
    test::prescribe_pores(model, "left", 1e5, [](const Point& p) { return p.x == 0.0; });
    test::prescribe_crack(model, "mouth", Schedule::constant(1e5), {0.0, 0.2});
    return model;
  };
  Model by_explicit = make();
  const test::Balance balance(by_explicit);
  const double dt = 0.9 * step_limits(make_flow_graph(by_explicit)).back().step;
  const int steps = 20'000;
  ExplicitStep scheme(by_explicit);
  Execution execution;
  for (int i = 0; i < steps; ++i) {
    scheme.advance(by_explicit, dt, execution);
  }
  EXPECT_LT(balance.error(by_explicit), round_off);
  Model by_implicit = make();
  const test::Balance implicit_balance(by_implicit);
  ImplicitFlow flow(by_implicit);
  test::advance_implicit(flow, by_implicit, steps * dt, 20 * dt);
  EXPECT_LT(implicit_balance.error(by_implicit), round_off);
  double difference = 0.0;
  for (const Index c : test::corners_of(by_implicit.mesh)) {
    difference = std::max(difference, std::abs(by_implicit.state.saturation[at(c)] -
                                               by_explicit.state.saturation[at(c)]));
  }
  for (const Index v : by_implicit.cracks.open_nodes()) {
    difference = std::max(difference, std::abs(by_implicit.state.crack_saturation[at(v)] -
                                               by_explicit.state.crack_saturation[at(v)]));
  }
  EXPECT_LT(difference, 0.02);
  EXPECT_GT(test::saturation_range(by_implicit).second, 0.99);
  EXPECT_LT(test::saturation_range(by_implicit).first, 0.5);
}

TEST(SeepageFace, OpensWhenFluidComesAndClosesWhenItIsPumpedAway) {
  for (const bool is_explicit : {false, true}) {
    test::FlowOptions options;
    options.fluid.bulk_modulus = 2.2e8;
    Model model =
        test::make_flow(test::make_grid({.columns = 8, .rows = 2, .height = 0.25}), options);
    test::face_pores(model, "right", 1e4, [](const Point& p) { return p.x == 1.0; });
    set_pores(model, [](const Point&) { return FluidState<double>{5e3, 1.0}; });
    // Inject, then pump.
    test::inject_pores(model, "well", {{0.0, 200.0}, {1e-6, -1e-6}, Interpolation::step},
                       {0.0, 0.125});
    const test::Balance balance(model);
    const auto run_to = [&](double end) {
      if (is_explicit) {
        ExplicitStep scheme(model);
        Execution execution;
        const double dt = 0.9 * step_limits(make_flow_graph(model)).back().step;
        const auto steps = static_cast<int>(std::ceil((end - model.state.time) / dt));
        const double step = (end - model.state.time) / steps;
        for (int i = 0; i < steps; ++i) {
          scheme.advance(model, step, execution);
          ASSERT_LE(model.rate[0], 0.0);
        }
      } else {
        ImplicitFlow flow(model);
        Execution execution;
        for (int i = 0; i < 50; ++i) {
          ASSERT_TRUE(flow.attempt(model, (end - model.state.time) / (50 - i), execution));
          flow.accept(model);
          ASSERT_LE(model.rate[0], 0.0);
        }
      }
    };
    // Below the outside pressure nothing leaves, and nothing enters either.
    run_to(0.01);
    EXPECT_EQ(model.let_in[0].total(), 0.0);
    // Later all that is injected leaves.
    run_to(200.0);
    EXPECT_NEAR(model.rate[0], -1e-6, 1e-9);
    EXPECT_NEAR(test::pore_pressure(model, {1.0, 0.125}), 1e4, 1e-6);
    const double left = model.let_in[0].total();
    // When the flow turns the face closes and the pressure behind it falls below the outside.
    run_to(400.0);
    EXPECT_EQ(model.rate[0], 0.0);
    EXPECT_LT(test::pore_pressure(model, {1.0, 0.125}), 1e4);
    EXPECT_LT(std::abs(model.let_in[0].total() - left), 0.02 * 2e-4);
    EXPECT_LT(balance.error(model), round_off);
  }
}

TEST(BigSteps, EmptyingAndRefillingConvergesOrShrinksTheStep) {
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u}) {
    const test::Grid grid{
        .columns = 8, .rows = 8, .jitter = 0.3, .seed = seed, .mixed_diagonals = true};
    auto file = test::make_grid(grid);
    test::add_column_curve(grid, file, "crack", 4, 1, 8);
    test::add_row_curve(grid, file, "branch", 5, 1, 6);
    test::FlowOptions options;
    options.gravity = 9.81;
    options.fracture = {{.initial_aperture = 1e-4,
                         .transmissivity = {},
                         .exchange = seed % 2 == 0 ? test::infinity : 1e-8}};
    Model model = test::make_flow(file, options);
    test::break_curve(model, "crack");
    test::break_curve(model, "branch");
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const auto state = [&](const Point&) { return FluidState<double>{0.0, unit(random)}; };
    set_pores(model, state);
    set_cracks(model, state);
    // Flooded for a day, drained for a day, and so on, with steps of half a day.
    Schedule tide{{}, {}, Interpolation::step};
    for (int day = 0; day < 8; ++day) {
      tide.time.push_back(day);
      tide.value.push_back(day % 2 == 0 ? 2e-6 : -1.4e-6);
    }
    test::inject_pores(model, "tide", tide, {0.25, 0.25});
    test::face_pores(model, "top", 0.0, [](const Point& p) { return p.y == 1.0; });
    test::face_pores(model, "right", 0.0, [](const Point& p) { return p.x == 1.0; });
    const test::Balance balance(model);
    ImplicitFlow flow(model);
    int attempts = 0;
    for (int day = 1; day <= 8; ++day) {
      attempts += test::advance_implicit(flow, model, day, 0.5);
    }
    EXPECT_LT(attempts, 20'000) << seed;
    EXPECT_LT(balance.error(model), round_off) << seed;
    EXPECT_GE(test::saturation_range(model).first, -1e-6) << seed;
  }
}

}  // namespace
}  // namespace percolith::seepage
