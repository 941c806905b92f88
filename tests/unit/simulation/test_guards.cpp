// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "unit/support/setup.hpp"

// What stops a run, warns, or must come out the same whichever scheme is chosen.
namespace percolith::simulation {
namespace {

class Guards : public testing::TestWithParam<Scheme> {};

Setup transient(Scheme scheme, double end) {
  simulation::Setup setup = test::plain_setup();
  setup.time.scheme = scheme;
  setup.time.end = end;
  return setup;
}

TEST_P(Guards, TakingMoreFluidThanThereIsStopsTheRun) {
  simulation::Setup setup = transient(GetParam(), 100.0);
  setup.boundary.clear();
  setup.source["pump"].point = {0.5, 0.5};
  setup.source["pump"].rate = Schedule::constant(-1e-2);
  test::Recorder recorder;
  try {
    test::run(setup, test::plain_mesh(), recorder);
    FAIL() << "the run went on";
  } catch (const SolverError& error) {
    EXPECT_NE(std::string(error.what()).find("takes more fluid than there is from the pore node"),
              std::string::npos)
        << error.what();
  }
  EXPECT_EQ(recorder.frames.size(), 1u);
}

TEST_P(Guards, AJumpAtAnOutputTimeActsAfterIt) {
  simulation::Setup setup = transient(GetParam(), 2e-3);
  setup.boundary["inlet"].pressure = Schedule{{0.0, 1e-3}, {0.0, 1e5}, Interpolation::step};
  setup.output.times = {1e-3};
  test::Recorder recorder;
  test::run(setup, test::plain_mesh(), recorder);
  ASSERT_EQ(recorder.frames.size(), 3u);
  const auto largest = [&](std::size_t frame) {
    const auto& pressure = recorder.frames[frame].matrix.pressure;
    return *std::max_element(pressure.begin(), pressure.end());
  };
  EXPECT_EQ(largest(1), 0.0);
  EXPECT_EQ(largest(2), 1e5);
}

TEST_P(Guards, AShareOfAMillionthOfTheRunIsTheShortestInterval) {
  simulation::Setup setup = transient(GetParam(), 1.0);
  setup.output.interval = 1e-9;
  test::expect_refused(setup, "output.interval", "1e+09 intervals fit into the 1 s of the run");
  setup.output.interval.reset();
  setup.output.history_interval = 1e-300;
  test::expect_refused(setup, "output.history_interval", "at most 1e+06");
}

TEST_P(Guards, ARunMayStartFromTheSteadyState) {
  simulation::Setup setup = transient(GetParam(), 0.1);
  setup.initial.steady = true;
  test::Recorder recorder;
  test::run(setup, test::plain_mesh(), recorder);
  for (const Frame& frame : {recorder.frames.front(), recorder.frames.back()}) {
    for (std::size_t i = 0; i < frame.matrix.points.size(); ++i) {
      EXPECT_NEAR(frame.matrix.pressure[i], 1e5 * (1.0 - frame.matrix.points[i].x), 1e-6);
    }
  }
  EXPECT_NEAR(recorder.history.front().rate.at("boundary.inlet"), 1e-13 * 1e5 / 1e-3, 1e-17);
  EXPECT_NEAR(recorder.history.back().balance.stored, 0.0, 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Schemes, Guards, testing::Values(Scheme::implicit, Scheme::explicit_),
                         [](const auto& scheme) {
                           return scheme.param == Scheme::implicit ? "implicit" : "explicit";
                         });

TEST(PlainGuards, ASteadyStartNeedsADatum) {
  simulation::Setup setup = transient(Scheme::implicit, 1.0);
  setup.boundary.clear();
  setup.initial.steady = true;
  test::expect_refused(setup, "initial.steady", "nothing fixes the pressure");
}

TEST(PlainGuards, WaterAtRestHasNoBalanceError) {
  simulation::Setup setup = test::plain_setup();
  setup.model.gravity = 9.81;
  setup.boundary.clear();
  setup.boundary["all"].groups = {"left", "right"};
  setup.boundary["all"].head = Schedule::constant(5.0);
  test::Recorder recorder;
  const Summary summary = test::run(setup, test::plain_mesh(), recorder);
  EXPECT_LT(summary.throughput, 1e-18);
  EXPECT_EQ(summary.last.balance.relative_error, 0.0);
}

TEST(PlainGuards, TheSteadyStateDoesNotDependOnTheInitialOne) {
  test::Recorder recorder;
  simulation::Setup setup = test::plain_setup();
  const std::string hash = test::run(setup, test::plain_mesh(), recorder).state_hash;
  setup.initial.pressure = 3e5;
  EXPECT_EQ(test::run(setup, test::plain_mesh(), recorder).state_hash, hash);
}

TEST(PlainGuards, ProbePointsOutsideAndMissingConditionsAreToldOf) {
  simulation::Setup setup = transient(Scheme::implicit, 1.0);
  setup.boundary.clear();
  setup.probe["line"].from = {0.5, 0.5};
  setup.probe["line"].to = {0.5, 1.5};
  setup.probe["line"].points = 5;
  test::Recorder recorder;
  const Summary summary = test::run(setup, test::plain_mesh(), recorder);
  ASSERT_EQ(summary.warnings.size(), 2u);
  EXPECT_EQ(recorder.warnings, summary.warnings);
  EXPECT_NE(summary.warnings[0].find("no boundary and no source table"), std::string::npos);
  EXPECT_EQ(summary.warnings[1], "probe.line: 2 of 5 points lie outside of the rock and are left "
                                 "out");
}

TEST(PlainGuards, CrackFluxOfAProbePointsDownThePressure) {
  simulation::Setup setup = test::plain_setup();
  setup.boundary.clear();
  setup.boundary["base"].groups = {"bottom"};
  setup.boundary["base"].pressure = Schedule::constant(1e5);
  setup.boundary["top"].groups = {"top"};
  setup.boundary["top"].pressure = Schedule::constant(0.0);
  setup.fracture["fault"] = test::fracture_group("upright", 1e-4);
  setup.probe["fault"].point = {0.5, 0.7};
  setup.probe["fault"].in = Domain::crack;
  test::Recorder recorder;
  test::run(setup, test::plain_mesh(), recorder);
  const ProbeSample& sample = recorder.probes.at(0).at(0);
  ASSERT_EQ(sample.columns.back(), "flux_y_m2_per_s");
  EXPECT_GT(sample.rows.at(0).values.back(), 0.0);
}

}  // namespace
}  // namespace percolith::simulation
