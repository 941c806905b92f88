// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <omp.h>

#include <cmath>

#include "unit/support/setup.hpp"

namespace percolith::simulation {
namespace {

using test::plain_setup;

/// Storage of the plain rock over its conductivity, s: the time a change takes to cross it.
constexpr double crossing_time = 0.2 / 2.2e9 * 1e-3 / 1e-13;

/// A flow that is let run far beyond the time it needs to settle.
Setup settling(Scheme scheme, double ratio) {
  simulation::Setup setup = plain_setup();
  setup.time.scheme = scheme;
  setup.time.end = (scheme == Scheme::explicit_ ? 20.0 : 1e6) * crossing_time;
  setup.time.stop_ratio = ratio;
  return setup;
}

/// Rock that fills from a lake on its left, and drains on its right.
Setup with_water_table() {
  simulation::Setup setup = settling(Scheme::implicit, 1e-3);
  setup.model.gravity = 9.81;
  setup.fluid.cavitation_pressure = 0.0;
  setup.material["sandstone"].rock.permeability = {1e-11, 1e-11, 0.0};
  setup.initial.water_table = 0.2;
  setup.initial.saturation = 0.3;
  setup.boundary.clear();
  setup.boundary["lake"].groups = {"left"};
  setup.boundary["lake"].head = Schedule::constant(1.0);
  setup.boundary["face"].groups = {"right"};
  setup.boundary["face"].seepage_face = Schedule::constant(0.0);
  setup.time.end = 1e9;
  return setup;
}

class Settles : public testing::TestWithParam<Scheme> {};

TEST_P(Settles, WhenWhatIsStoredIsASmallShareOfWhatFlowsThrough) {
  const double exact = 1e-13 / 1e-3 * 1e5;  // through a square
  for (const double ratio : {1e-2, 1e-4}) {
    test::Recorder recorder;
    const simulation::Setup setup = settling(GetParam(), ratio);
    const Summary summary = test::run(setup, test::plain_mesh(), recorder);
    EXPECT_TRUE(summary.reached_rest);
    EXPECT_LT(summary.end_time, 0.5 * setup.time.end);
    ASSERT_TRUE(summary.settlement.has_value());
    EXPECT_LE(summary.settlement->change, ratio);
    EXPECT_FALSE(summary.settlement->is_rest);
    // Each rate is as near to that of the steady flow.
    EXPECT_NEAR(summary.last.rate.at("boundary.inlet"), exact, ratio * exact);
    EXPECT_NEAR(summary.last.rate.at("boundary.outlet"), -exact, ratio * exact);
    // The end is reported as any other.
    EXPECT_EQ(recorder.frames.back().time, summary.end_time);
    EXPECT_EQ(recorder.history.back().time, summary.end_time);
    EXPECT_EQ(recorder.progress.back().step, summary.steps);
  }
}

TEST_P(Settles, NotWhileInflowEqualsOutflowButTheRockChangesWithin) {
  // The two sides of the rock mirror each other: fluid in equals fluid out from the first step on.
  simulation::Setup setup = settling(GetParam(), 0.5);
  setup.initial.pressure = 5e4;
  const Summary sloppy = [&] {
    test::Recorder recorder;
    return test::run(setup, test::plain_mesh(), recorder);
  }();
  EXPECT_NEAR(sloppy.last.rate.at("boundary.inlet"), -sloppy.last.rate.at("boundary.outlet"),
              1e-6 * sloppy.throughput);
  setup.time.stop_ratio = 1e-3;
  test::Recorder recorder;
  const Summary strict = test::run(setup, test::plain_mesh(), recorder);
  EXPECT_GT(strict.end_time, 0.1 * crossing_time);
  EXPECT_NEAR(strict.last.rate.at("boundary.inlet"), 1e-5, 1e-3 * 1e-5);
}

TEST_P(Settles, NotBeforeItsSchedulesDo) {
  simulation::Setup setup = settling(GetParam(), 0.1);
  const double late = 0.4 * setup.time.end;
  setup.boundary["inlet"].pressure = Schedule{{0.0, late}, {1e5, 2e5}, Interpolation::step};
  test::Recorder recorder;
  Summary summary = test::run(setup, test::plain_mesh(), recorder);
  EXPECT_TRUE(summary.reached_rest);
  EXPECT_GT(summary.end_time, late);
  EXPECT_NEAR(summary.last.rate.at("boundary.inlet"), 2e-5, 0.1 * 2e-5);
  // A rise that goes on to the end, so slow that the flow follows it at every time.
  setup.time.end *= 100.0;
  setup.time.scheme = Scheme::implicit;
  setup.boundary["inlet"].pressure = Schedule{{0.0, 2.0 * setup.time.end}, {1e5, 2e5}};
  summary = test::run(setup, test::plain_mesh(), recorder);
  EXPECT_FALSE(summary.reached_rest);
  EXPECT_EQ(summary.end_time, setup.time.end);
  EXPECT_LT(summary.settlement->change, 0.1);
}

TEST_P(Settles, WhereFluidComesToRest) {
  // The impervious end fills up: throughput and change vanish together.
  simulation::Setup setup = settling(GetParam(), 1e-3);
  setup.boundary.erase("outlet");
  test::Recorder recorder;
  const Summary summary = test::run(setup, test::plain_mesh(), recorder);
  EXPECT_TRUE(summary.reached_rest);
  EXPECT_TRUE(summary.settlement->is_rest);
  EXPECT_NEAR(summary.last.minimum_pressure, 1e5, 1e-2 * 1e5);
}

TEST_P(Settles, AtOnceWhereNothingFlows) {
  for (const double gravity : {0.0, 9.81}) {
    simulation::Setup setup = settling(GetParam(), 1e-6);
    setup.model.gravity = gravity;
    setup.boundary.clear();
    setup.initial.pressure = 0.0;
    if (gravity > 0.0) {
      setup.initial.pressure.reset();
      setup.initial.head = 5.0;
    }
    test::Recorder recorder;
    const Summary summary = test::run(setup, test::plain_mesh(), recorder);
    EXPECT_TRUE(summary.reached_rest);
    EXPECT_TRUE(summary.settlement->is_rest);
    EXPECT_LE(summary.steps, 600);
  }
}

TEST_P(Settles, NeverWhereAPumpFillsAClosedRock) {
  simulation::Setup setup = settling(GetParam(), 0.5);
  setup.time.end = 20.0 * crossing_time;
  setup.boundary.clear();
  setup.source["pump"].point = {0.4, 0.6};
  setup.source["pump"].rate = Schedule::constant(1e-6);
  test::Recorder recorder;
  const Summary summary = test::run(setup, test::plain_mesh(), recorder);
  EXPECT_FALSE(summary.reached_rest);
  EXPECT_EQ(summary.end_time, setup.time.end);
  EXPECT_NEAR(summary.settlement->change, 1.0, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Schemes, Settles, testing::Values(Scheme::implicit, Scheme::explicit_),
                         [](const auto& scheme) {
                           return scheme.param == Scheme::implicit ? "implicit" : "explicit";
                         });

TEST(Settling, IsNotLookedForUnlessWanted) {
  simulation::Setup setup = settling(Scheme::implicit, 1e-3);
  setup.time.stop_ratio.reset();
  test::Recorder recorder;
  const Summary summary = test::run(setup, test::plain_mesh(), recorder);
  EXPECT_EQ(summary.end_time, setup.time.end);
  EXPECT_FALSE(summary.settlement.has_value());
}

TEST(Settling, EndsHoweverFarOffTheEndIs) {
  simulation::Setup setup = settling(Scheme::implicit, 1e-3);
  setup.time.end = 1e20;
  test::Recorder recorder;
  const Summary summary = test::run(setup, test::plain_mesh(), recorder);
  EXPECT_TRUE(summary.reached_rest);
  EXPECT_LT(summary.end_time, 100.0 * crossing_time);
}

TEST(Settling, EndsWithAWaterTable) {
  test::Recorder recorder;
  const Summary summary = test::run(with_water_table(), test::plain_mesh(), recorder);
  EXPECT_TRUE(summary.reached_rest);
  EXPECT_LT(summary.end_time, 1e9);
  EXPECT_LT(summary.last.minimum_saturation, 0.5);
  const double in = summary.last.rate.at("boundary.lake");
  EXPECT_GT(in, 0.0);
  EXPECT_NEAR(in + summary.last.rate.at("boundary.face"), 0.0, 1e-3 * in);
}

TEST(Settling, ComesAtTheSameStepWithAnyNumberOfThreads) {
  const int before = omp_get_max_threads();
  std::vector<Summary> ends;
  for (const int threads : {1, 2}) {
    omp_set_num_threads(threads);
    test::Recorder recorder;
    simulation::Setup setup = with_water_table();
    setup.initial.water_table = 1.0;  // fewer steps lead there
    ends.push_back(
        test::run(setup, test::plain_mesh({.columns = 20, .rows = 20, .jitter = 0.2}), recorder));
  }
  omp_set_num_threads(before);
  EXPECT_TRUE(ends[0].reached_rest);
  EXPECT_EQ(ends[0].steps, ends[1].steps);
  EXPECT_EQ(ends[0].state_hash, ends[1].state_hash);
  EXPECT_EQ(ends[0].settlement->change, ends[1].settlement->change);
}

}  // namespace
}  // namespace percolith::simulation
