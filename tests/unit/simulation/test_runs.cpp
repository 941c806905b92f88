// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "unit/support/setup.hpp"

namespace percolith::simulation {
namespace {

using test::plain_setup;

/// Storage of the plain rock, m2/Pa, and its time of diffusion, s.
constexpr double storage = 0.2 / 2.2e9;
constexpr double diffusion_time = 1.0 / (1e-13 * (2.2e9 / 0.2) / 1e-3);

/// A sealed box with a well.
Setup box(Scheme scheme, double end) {
  simulation::Setup setup = plain_setup();
  setup.boundary.clear();
  setup.time.scheme = scheme;
  setup.time.end = end;
  setup.source["well"].point = {0.4, 0.6};
  setup.source["well"].rate = Schedule::constant(1e-6);
  return setup;
}

class Transient : public testing::TestWithParam<Scheme> {};

TEST_P(Transient, FramesComeAtTheStartAtOutputTimesAndAtTheEnd) {
  simulation::Setup setup = box(GetParam(), 2.0);
  setup.output.times = {0.33, 1.1};
  setup.output.interval = 0.5;
  setup.output.history_interval = 0.1;
  setup.probe["gauge"].point = {0.5, 0.5};
  test::Recorder recorder;
  const Summary summary = test::run(setup, test::plain_mesh(), recorder);
  const std::vector<double> expected{0.0, 0.33, 0.5, 1.0, 1.1, 1.5, 2.0};
  ASSERT_EQ(recorder.frames.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(recorder.frames[i].time, expected[i]);
  }
  EXPECT_EQ(recorder.probe_times, expected);
  EXPECT_EQ(summary.end_time, 2.0);
  EXPECT_EQ(summary.steps, static_cast<std::int64_t>(recorder.progress.size()));
  EXPECT_EQ(recorder.frames.back().step, summary.steps);
  EXPECT_EQ(summary.last.time, 2.0);
  EXPECT_EQ(recorder.history.back().time, 2.0);
  EXPECT_EQ(recorder.history.front().time, 0.0);
  double before = 0.0;
  for (const Progress& p : recorder.progress) {
    EXPECT_GT(p.time, before);
    EXPECT_NEAR(p.time - before, p.step_size, 1e-12);
    EXPECT_EQ(p.end, 2.0);
    EXPECT_STRNE(p.limited_by, "");
    before = p.time;
  }
  EXPECT_FALSE(summary.wall_time.empty());
  EXPECT_EQ(summary.state_hash.size(), 16u);
}

TEST_P(Transient, WhatIsInjectedIsStored) {
  simulation::Setup setup = box(GetParam(), 2.0);
  // Up in one second, down in another, half off: all in straight lines and one jump.
  setup.source["well"].rate = Schedule{{0.0, 0.7, 1.2}, {0.0, 2e-6, 1e-6}, Interpolation::linear};
  setup.source["pump"].point = {0.9, 0.1};
  setup.source["pump"].rate = Schedule{{0.0, 0.5}, {-1e-7, -3e-7}, Interpolation::step};
  test::Recorder recorder;
  const Summary summary = test::run(setup, test::plain_mesh(), recorder);
  const MassBalance& balance = summary.last.balance;
  const double in = 0.5 * 0.7 * 2e-6 + 0.5 * 0.5 * 3e-6 + 0.8 * 1e-6;
  const double out = 0.5 * 1e-7 + 1.5 * 3e-7;
  EXPECT_NEAR(balance.by_condition.at("source.well"), in, 1e-11 * in);
  EXPECT_NEAR(balance.by_condition.at("source.pump"), -out, 1e-11 * in);
  EXPECT_NEAR(balance.in, in, 1e-11 * in);
  EXPECT_NEAR(balance.out, out, 1e-11 * in);
  EXPECT_NEAR(balance.stored, in - out, 1e-9 * in);
  EXPECT_LT(balance.relative_error, 1e-14);
  EXPECT_NEAR(balance.in_place, 0.2 + in - out, 1e-13);
  EXPECT_NEAR(summary.last.rate.at("source.well"), 1e-6, 1e-17);
  // The mean pressure is content over storage.
  double mean = 0.0;
  const MatrixFrame& matrix = recorder.frames.back().matrix;
  for (const auto& triangle : matrix.triangles) {
    for (const auto p : triangle) {
      mean += matrix.pressure[static_cast<std::size_t>(p)] / (3.0 * 128.0);
    }
  }
  EXPECT_NEAR(mean, (in - out) / storage, 1e-6 * mean);
}

TEST_P(Transient, StopsAfterTheStepInHandWithALastFrame) {
  test::Recorder recorder;
  Simulation simulation(box(GetParam(), 2.0), test::plain_mesh());
  int steps = 0;
  simulation.run(recorder, [&] { return ++steps == 3; });
  const Summary summary = simulation.summary();
  EXPECT_EQ(summary.steps, 3);
  EXPECT_GT(summary.end_time, 0.0);
  EXPECT_LT(summary.end_time, 2.0);
  ASSERT_EQ(recorder.frames.size(), 2u);
  EXPECT_EQ(recorder.frames.back().time, summary.end_time);
  EXPECT_EQ(recorder.history.back().time, summary.end_time);
}

TEST_P(Transient, OutputTimesThatRoundOffMovesDoNotStopTheRun) {
  simulation::Setup setup = box(GetParam(), 1.0);
  setup.output.interval = 0.1;
  setup.output.times = {0.3};  // three times 0.1 is a digit more
  setup.source["well"].rate = Schedule{{0.0, 0.7}, {1e-6, 2e-6}, Interpolation::step};
  test::Recorder recorder;
  const Summary summary = test::run(setup, test::plain_mesh(), recorder);
  EXPECT_EQ(summary.end_time, 1.0);
  EXPECT_EQ(recorder.frames.size(), 11u);
  EXPECT_NEAR(summary.last.balance.in, 0.7e-6 + 0.6e-6, 1e-16);
}

INSTANTIATE_TEST_SUITE_P(Schemes, Transient, testing::Values(Scheme::implicit, Scheme::explicit_),
                         [](const auto& scheme) {
                           return scheme.param == Scheme::implicit ? "implicit" : "explicit";
                         });

TEST(ImplicitRun, TheToleranceRulesTheErrorAndTheStepGrows) {
  const auto pressure = [](double tolerance, std::int64_t* steps) {
    simulation::Setup setup = plain_setup();
    setup.time.scheme = Scheme::implicit;
    setup.time.end = 0.1 * diffusion_time;
    setup.time.tolerance = tolerance;
    setup.probe["gauge"].point = {0.5, 0.5};
    test::Recorder recorder;
    *steps = test::run(setup, test::plain_mesh(), recorder).steps;
    return recorder.probes.back().at(0).rows.at(0).values.at(0);
  };
  std::int64_t coarse_steps = 0;
  std::int64_t fine_steps = 0;
  std::int64_t reference_steps = 0;
  const double reference = pressure(1e-7, &reference_steps);
  const double coarse = std::abs(pressure(1e-2, &coarse_steps) - reference);
  const double fine = std::abs(pressure(1e-4, &fine_steps) - reference);
  EXPECT_LT(coarse_steps, fine_steps);
  EXPECT_LT(fine_steps, reference_steps);
  EXPECT_LT(fine, 0.3 * coarse);
  EXPECT_LT(fine, 1e-2 * 1e5);
}

TEST(ImplicitRun, AGivenStepIsKept) {
  simulation::Setup setup = box(Scheme::implicit, 1.0);
  setup.time.step = 0.125;
  test::Recorder recorder;
  const Summary summary = test::run(setup, test::plain_mesh(), recorder);
  EXPECT_EQ(summary.steps, 8);
  EXPECT_EQ(summary.rejected_steps, 0);
  EXPECT_STREQ(recorder.progress[3].limited_by, "given step");
}

TEST(ImplicitRun, StepsStayBelowTheMaximum) {
  simulation::Setup setup = box(Scheme::implicit, 100.0);
  setup.time.maximum_step = 0.7;
  test::Recorder recorder;
  test::run(setup, test::plain_mesh(), recorder);
  double longest = 0.0;
  for (const Progress& p : recorder.progress) {
    longest = std::max(longest, p.step_size);
  }
  EXPECT_NEAR(longest, 0.7, 1e-9);
}

TEST(ImplicitRun, StartsWithTheInitialStep) {
  simulation::Setup setup = plain_setup();
  setup.time.scheme = Scheme::implicit;
  setup.time.end = 1.0;
  setup.time.initial_step = 1e-7;
  test::Recorder recorder;
  test::run(setup, test::plain_mesh(), recorder);
  EXPECT_EQ(recorder.progress.front().step_size, 1e-7);
  EXPECT_EQ(recorder.progress[1].step_size, 2e-7);
}

TEST(ImplicitRun, InjectionIntoRockAtOnePressureFindsItsFirstStep) {
  // The pressure range is what the injection makes it, so the error relative to it stays.
  for (const double rate : {1e-12, 1e-6, -1e-6}) {
    simulation::Setup setup = box(Scheme::implicit, 5.0);
    setup.fluid.cavitation_pressure = -std::numeric_limits<double>::infinity();
    setup.source["well"].rate = Schedule::constant(rate);
    test::Recorder recorder;
    const Summary summary = test::run(setup, test::plain_mesh(), recorder);
    EXPECT_LT(summary.steps, 300);
    EXPECT_LT(summary.rejected_steps, 30);
    EXPECT_LT(summary.last.balance.relative_error, 1e-14);
  }
}

TEST(ImplicitRun, SaysSoWhenNoStepHasASolution) {
  simulation::Setup setup = box(Scheme::implicit, 1.0);
  setup.source["well"].rate = Schedule::constant(1e300);
  test::Recorder recorder;
  try {
    test::run(setup, test::plain_mesh(), recorder);
    FAIL() << "no error";
  } catch (const SolverError& error) {
    const std::string text = error.what();
    EXPECT_TRUE(text.find("the implicit step found no solution at time") != std::string::npos ||
                text.find("is not a number at time") != std::string::npos)
        << text;
    EXPECT_NE(text.find("the results up to the last output are kept"), std::string::npos) << text;
  }
  EXPECT_EQ(recorder.frames.size(), 1u);
}

TEST(ExplicitRun, AValueThatIsNoNumberStopsWithTimeAndPlace) {
  simulation::Setup setup = box(Scheme::explicit_, 1.0);
  // Everything is fine until the well runs wild after the first output.
  setup.source["well"].rate = Schedule{{0.0, 0.5}, {1e-6, 1e308}, Interpolation::step};
  setup.output.times = {0.25};
  test::Recorder recorder;
  try {
    test::run(setup, test::plain_mesh(), recorder);
    FAIL() << "no error";
  } catch (const SolverError& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.rfind("the pore pressure at (", 0), 0u) << text;
    EXPECT_NE(text.find("is not a number at time "), std::string::npos) << text;
    EXPECT_NE(text.find("the results up to the last output are kept"), std::string::npos) << text;
  }
  ASSERT_EQ(recorder.frames.size(), 2u);
  for (const Frame& frame : recorder.frames) {
    for (const double p : frame.matrix.pressure) {
      EXPECT_TRUE(std::isfinite(p));
    }
  }
}

TEST(ExplicitRun, AGivenStepIsAnUpperBound) {
  simulation::Setup setup = box(Scheme::explicit_, 0.1);
  test::Recorder free;
  test::run(setup, test::plain_mesh(), free);
  EXPECT_STREQ(free.progress.front().limited_by, "pore flow");
  setup.time.step = 1e-4;
  test::Recorder bounded;
  test::run(setup, test::plain_mesh(), bounded);
  EXPECT_STREQ(bounded.progress.front().limited_by, "given step");
  EXPECT_EQ(bounded.progress.front().step_size, 1e-4);
  EXPECT_GT(free.progress.front().step_size, 1e-4);
  setup.time.step = 1e3;
  test::Recorder capped;
  test::run(setup, test::plain_mesh(), capped);
  EXPECT_EQ(capped.progress.front().step_size, free.progress.front().step_size);
}

TEST(Runs, ExplicitAndImplicitAgreeWhereAFaceMeetsAGivenPressure) {
  // At the corner (1, 1) the given pressure holds, not the seepage face.
  simulation::Setup setup = plain_setup();
  setup.boundary["outlet"].pressure.reset();
  setup.boundary["outlet"].seepage_face = Schedule::constant(0.0);
  setup.boundary["roof"].groups = {"top"};
  setup.boundary["roof"].pressure = Schedule::constant(1e5);
  setup.time.end = 2.0 * diffusion_time;
  std::vector<double> corner;
  std::vector<double> rate;
  for (const Scheme scheme : {Scheme::steady, Scheme::implicit, Scheme::explicit_}) {
    setup.time.scheme = scheme;
    setup.probe["corner"].point = {1.0, 1.0};
    test::Recorder recorder;
    const Summary summary = test::run(setup, test::plain_mesh(), recorder);
    corner.push_back(recorder.probes.back().at(0).rows.at(0).values.at(0));
    rate.push_back(summary.last.rate.at("boundary.outlet"));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(corner[i], 1e5, 1e-6);
    EXPECT_NEAR(rate[i], rate[0], 1e-3 * std::abs(rate[0]));
    EXPECT_LT(rate[i], 0.0);
  }
}

TEST(Runs, HeadFluxAndFracturePressureActTogether) {
  simulation::Setup setup = plain_setup();
  setup.boundary["inlet"].pressure.reset();
  setup.boundary["inlet"].flux = Schedule::constant(2e-6);
  setup.fracture["fault"] = test::fracture_group("upright", 1e-4, 1e-9);
  setup.source["gallery"].fractures = {"fault"};
  setup.source["gallery"].pressure = Schedule::constant(1e3);
  test::Recorder recorder;
  const Summary summary = test::run(setup, test::plain_mesh(), recorder);
  EXPECT_NEAR(summary.last.rate.at("boundary.inlet"), 2e-6, 1e-18);
  EXPECT_NEAR(summary.last.rate.at("boundary.outlet") + summary.last.rate.at("source.gallery"),
              -2e-6, 1e-16);
  EXPECT_EQ(summary.last.minimum_crack_pressure, 1e3);
  EXPECT_EQ(summary.last.maximum_crack_pressure, 1e3);
  EXPECT_LT(summary.last.balance.relative_error, 1e-10);
}

TEST(Runs, ARateIntoAFractureIsSharedByLengthAndReachesTheRock) {
  simulation::Setup setup = plain_setup();
  setup.fracture["fault"] = test::fracture_group("upright", 1e-4, 1e-9);
  setup.source["feed"].fractures = {"fault"};
  setup.source["feed"].rate = Schedule::constant(3e-6);
  test::Recorder recorder;
  const Summary summary = test::run(setup, test::plain_mesh(), recorder);
  EXPECT_NEAR(summary.last.rate.at("source.feed"), 3e-6, 1e-18);
  EXPECT_NEAR(summary.last.rate.at("boundary.inlet") + summary.last.rate.at("boundary.outlet"),
              -3e-6, 1e-15);
}

TEST(Runs, NumberingOfTheFileChangesNothingBeyondRoundOff) {
  simulation::Setup setup = plain_setup();
  setup.fracture["fault"] = test::fracture_group("upright", 1e-4, 1e-9);
  setup.fracture["level"] = test::fracture_group("level", 5e-5, 1e-8);
  std::vector<std::pair<double, double>> reference;
  setup.probe["line"].from = {0.01, 0.3};
  setup.probe["line"].to = {0.99, 0.62};
  const auto file = test::plain_mesh(
      {.columns = 12, .rows = 12, .jitter = 0.0, .seed = 3, .mixed_diagonals = true});
  std::vector<double> first;
  for (const unsigned seed : {0u, 1u, 2u}) {
    test::Recorder recorder;
    test::run(setup, seed == 0 ? file : test::shuffled(file, seed), recorder);
    std::vector<double> pressures;
    for (const ProbeRow& row : recorder.probes.at(0).at(0).rows) {
      pressures.push_back(row.values[0]);
    }
    if (seed == 0) {
      first = pressures;
    }
    ASSERT_EQ(pressures.size(), first.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
      EXPECT_NEAR(pressures[i], first[i], 1e-9 * 1e5);
    }
  }
}

std::string hash_with(int threads, Scheme scheme) {
  const int before = omp_get_max_threads();
  omp_set_num_threads(threads);
  // Large enough that the loops are shared.
  const auto mesh = test::plain_mesh(
      {.columns = 72, .rows = 72, .jitter = 0.0, .seed = 2, .mixed_diagonals = true});
  simulation::Setup setup = plain_setup();
  setup.model.gravity = 9.81;
  setup.boundary["inlet"].pressure = Schedule::constant(5e4);
  setup.fracture["fault"] = test::fracture_group("upright", 1e-5, 1e-9);
  setup.initial.water_table = 0.5;
  setup.initial.saturation = 0.4;
  setup.time.scheme = scheme;
  setup.time.end = scheme == Scheme::explicit_ ? 1e-3 : 10.0;
  setup.time.step = scheme == Scheme::implicit ? std::optional<double>(2.5) : std::nullopt;
  test::Recorder recorder;
  const Summary summary = test::run(setup, mesh, recorder);
  omp_set_num_threads(before);
  EXPECT_GT(summary.steps, 3);
  return summary.state_hash;
}

TEST(Runs, OneAndTwoThreadsGiveTheSameBits) {
  for (const Scheme scheme : {Scheme::implicit, Scheme::explicit_}) {
    EXPECT_EQ(hash_with(1, scheme), hash_with(2, scheme));
  }
}

TEST(Runs, ASteadyRunWarnsThatItTakesTheValueAtTimeZero) {
  simulation::Setup setup = plain_setup();
  setup.boundary["inlet"].pressure = Schedule{{0.0, 5.0}, {1e5, 2e5}, Interpolation::linear};
  setup.fracture["fault"] = test::fracture_group("upright", 1e-4, 1e-9);
  setup.fracture["fault"].fracture.maximum_aperture = 5e-5;
  test::Recorder recorder;
  const Summary summary = test::run(setup, test::plain_mesh(), recorder);
  EXPECT_EQ(recorder.warnings,
            (std::vector<std::string>{
                "fracture.fault.initial_aperture = 0.0001 m is outside of its limits; the "
                "hydraulic aperture is 5e-05 m",
                "boundary.inlet depends on time; a steady run uses its value at time 0"}));
  EXPECT_EQ(summary.warnings, recorder.warnings);
  EXPECT_NEAR(summary.last.maximum_pressure, 1e5, 1e-6);
  EXPECT_EQ(summary.last.minimum_pressure, 0.0);
}

}  // namespace
}  // namespace percolith::simulation
