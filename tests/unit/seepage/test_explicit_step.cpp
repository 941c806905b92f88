// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/hash.hpp"
#include "percolith/seepage/explicit_step.hpp"
#include "percolith/seepage/step_limit.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "unit/seepage/reference_step.hpp"
#include "unit/support/flow_model.hpp"

namespace percolith::seepage {
namespace {

using test::at;

struct Variant {
  const char* name;
  bool partly_empty = false;
  double gravity = 0.0;
  PoreJoints joints = PoreJoints::tied;
  bool cracked = false;
  SaturationWeight weight = SaturationWeight::upstream;
};

const Variant variants[] = {
    {"saturated"},
    {"partly_saturated", true},
    {"gravity", true, 9.81},
    {"finite_joints", true, 9.81, PoreJoints::finite},
    {"cracks", true, 9.81, PoreJoints::tied, true},
    {"finite_joints_and_cracks", true, 9.81, PoreJoints::finite, true},
    {"mean_weight", true, 9.81, PoreJoints::tied, true, SaturationWeight::mean},
    {"saturated_cracks", false, 9.81, PoreJoints::tied, true},
};

test::FlowOptions options_of(const Variant& v) {
  test::FlowOptions options;
  options.gravity = v.gravity;
  options.joints = v.joints;
  options.weight = v.weight;
  options.rock.permeability = {3e-13, 1e-13, -1.2e-13};
  options.rock.biot_modulus = 7e9;
  options.fracture = {{.initial_aperture = 1e-5, .transmissivity = {}, .exchange = 2e-9},
                      {.initial_aperture = 2e-5, .transmissivity = {}, .exchange = 5e-10}};
  return options;
}

Model make_variant(const Variant& v, const test::Grid& grid) {
  auto file = test::make_grid(grid);
  const int column = grid.columns / 2;
  const int row = grid.rows / 2;
  test::add_column_curve(grid, file, "upright", column, 0, grid.rows - 1);
  test::add_row_curve(grid, file, "level", row, 1, grid.columns - 1);
  Model model = test::make_flow(file, options_of(v));
  if (v.cracked) {
    test::break_curve(model, "upright", 0);
    test::break_curve(model, "level", 1);
  }
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto state = [&](const Point&) {
    return v.partly_empty && unit(random) < 0.4 ? FluidState<double>{0.0, unit(random)}
                                                : FluidState<double>{1e5 * unit(random), 1.0};
  };
  set_pores(model, state);
  set_cracks(model, state);
  return model;
}

double stable_step(const Model& model) {
  return step_limits(make_flow_graph(model)).back().step;
}

const test::Grid irregular{.columns = 9, .rows = 8, .jitter = 0.3, .mixed_diagonals = true};

class ExplicitVariants : public testing::TestWithParam<Variant> {};

TEST_P(ExplicitVariants, AStepEqualsThePlainReference) {
  Model model = make_variant(GetParam(), irregular);
  const auto options = options_of(GetParam());
  ExplicitStep scheme(model);
  Execution execution;
  const double dt = 0.5 * stable_step(model);
  for (int step = 0; step < 5; ++step) {
    const auto expected = reference::Step(model, options).advance(dt);
    scheme.advance(model, dt, execution);
    for (const Index c : test::corners_of(model.mesh)) {
      ASSERT_NEAR(model.state.pressure[at(c)], expected.pressure[at(c)], 1e-6);
      ASSERT_NEAR(model.state.saturation[at(c)], expected.saturation[at(c)], 1e-12);
    }
    for (const Index v : model.cracks.open_nodes()) {
      ASSERT_NEAR(model.state.crack_pressure[at(v)], expected.crack_pressure[at(v)], 1e-6);
      ASSERT_NEAR(model.state.crack_saturation[at(v)], expected.crack_saturation[at(v)], 1e-12);
    }
  }
}

std::string bits_after(const Variant& v, Execution execution) {
  // Large enough that every loop is shared between threads.
  Model model =
      make_variant(v, {.columns = 70, .rows = 65, .jitter = 0.3, .mixed_diagonals = true});
  test::prescribe_pores(model, "left", 5e4, [](const Point& p) { return p.x == 0.0; });
  ExplicitStep scheme(model);
  const double dt = 0.9 * stable_step(model);
  for (int step = 0; step < 10; ++step) {
    scheme.advance(model, dt, execution);
  }
  StateHash hash;
  hash.add(model.state.pressure);
  hash.add(model.state.saturation);
  hash.add(model.state.content);
  hash.add(model.state.content_carry);
  hash.add(model.state.crack_content);
  hash.add(model.state.crack_pressure);
  return hash.text();
}

TEST_P(ExplicitVariants, EveryBackendAndNumberOfThreadsGivesTheSameBits) {
  const std::string serial = bits_after(GetParam(), Execution(Backend::serial));
  EXPECT_EQ(bits_after(GetParam(), Execution(Backend::host, 1)), serial);
  EXPECT_EQ(bits_after(GetParam(), Execution(Backend::host, 2)), serial);
}

TEST_P(ExplicitVariants, FluidIsConserved) {
  Model model = make_variant(GetParam(), irregular);
  test::prescribe_pores(model, "left", 2e5, [](const Point& p) { return p.x == 0.0; });
  test::face_pores(model, "right", 1e4, [](const Point& p) { return p.x == 1.0; });
  test::inject_pores(model, "well", Schedule::constant(1e-9), {0.3, 0.3});
  ExplicitStep scheme(model);
  Execution execution;
  const test::Balance balance(model);
  const double dt = 0.9 * stable_step(model);
  for (int step = 0; step < 500; ++step) {
    scheme.advance(model, dt, execution);
  }
  EXPECT_LT(balance.error(model), 1e-13);
  EXPECT_NEAR(model.let_in[2].total(), 1e-9 * 500 * dt, 1e-12 * 1e-9 * 500 * dt);
  EXPECT_NEAR(model.state.time, 500 * dt, 1e-10 * 500 * dt);
  if (GetParam().weight == SaturationWeight::upstream) {
    EXPECT_GE(test::saturation_range(model).first, -1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Variants, ExplicitVariants, testing::ValuesIn(variants),
                         [](const auto& variant) { return std::string(variant.param.name); });

TEST(ExplicitStep, IsStableBelowItsLimitAndNotFarAboveIt) {
  test::FlowOptions options;
  options.fluid.cavitation_pressure = -test::infinity;
  const auto largest_after = [&](double share) {
    Model model = test::make_flow(test::make_grid({.columns = 16, .rows = 16}), options);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> pressure(-1e5, 1e5);
    set_pores(model, [&](const Point&) { return FluidState<double>{pressure(random), 1.0}; });
    ExplicitStep scheme(model);
    Execution execution;
    const double dt = share * stable_step(model);
    for (int step = 0; step < 600; ++step) {
      scheme.advance(model, dt, execution);
    }
    double largest = 0.0;
    for (const Index c : test::corners_of(model.mesh)) {
      largest = std::max(largest, std::abs(model.state.pressure[at(c)]));
    }
    return largest;
  };
  EXPECT_LE(largest_after(0.999), 1e5);
  // The limit is that of the worst node; the whole grid follows within a factor of two.
  EXPECT_GT(largest_after(2.0), 1e8);
}

TEST(StepLimits, NameEachMechanismAndTheSmallestFirst) {
  const test::Grid grid{.columns = 4, .rows = 4};
  auto file = test::make_grid(grid);
  test::add_row_curve(grid, file, "crack", 2, 1, 3);
  test::FlowOptions options;
  options.joints = PoreJoints::finite;
  Model model = test::make_flow(file, options);
  test::break_curve(model, "crack");
  const FlowGraph graph = make_flow_graph(model);
  const auto limits = step_limits(graph);
  ASSERT_EQ(limits.size(), 5u);
  EXPECT_EQ(limits.back().mechanism, "all together");
  double rate = 0.0;
  for (std::size_t i = 0; i + 1 < limits.size(); ++i) {
    EXPECT_TRUE(i == 0 || limits[i - 1].step <= limits[i].step);
    EXPECT_LE(limits.back().step, limits[i].step);
    rate += 1.0 / limits[i].step;
    if (limits[i].mechanism == "crack flow") {
      // V = a L and two conductances a^3/(12 mu L): 6 mu L^2/(K_w a^2).
      EXPECT_NEAR(limits[i].step, 6.0 * 1e-3 * 0.25 * 0.25 / (2.2e9 * 1e-8),
                  1e-12 * limits[i].step);
    }
    if (limits[i].mechanism == "exchange") {
      // A tip: V = a L/2 and two faces with h L/2 each.
      EXPECT_NEAR(limits[i].step, 0.5 * 1e-4 / (2.2e9 * 1e-9), 1e-12 * limits[i].step);
    }
  }
  EXPECT_GE(limits.back().step, 1.0 / rate * (1.0 - 1e-12));
}

TEST(ExplicitStep, SeesJointsThatBreakOnTheWay) {
  const test::Grid grid{.columns = 6, .rows = 6};
  auto file = test::make_grid(grid);
  test::add_row_curve(grid, file, "crack", 3, 1, 5);
  test::FlowOptions options;
  options.fracture = {{.initial_aperture = 1e-5, .transmissivity = {}, .exchange = 2e-9}};
  Model model = test::make_flow(file, options);
  set_pores(model, [](const Point& p) { return FluidState<double>{1e5 * (1.0 + p.y), 1.0}; });
  ExplicitStep scheme(model);
  Execution execution;
  const test::Balance balance(model);
  scheme.advance(model, 1e-4, execution);
  test::break_curve(model, "crack");
  scheme.network_changed(model);
  const double dt = 0.5 * stable_step(model);
  const auto expected = reference::Step(model, options).advance(dt);
  scheme.advance(model, dt, execution);
  for (const Index c : test::corners_of(model.mesh)) {
    ASSERT_NEAR(model.state.pressure[at(c)], expected.pressure[at(c)], 1e-6);
  }
  for (const Index v : model.cracks.open_nodes()) {
    EXPECT_NEAR(model.state.crack_saturation[at(v)], expected.crack_saturation[at(v)], 1e-12);
    EXPECT_GT(model.state.crack_saturation[at(v)], 0.0);
  }
  EXPECT_LT(balance.error(model), 1e-14);
}

}  // namespace
}  // namespace percolith::seepage
