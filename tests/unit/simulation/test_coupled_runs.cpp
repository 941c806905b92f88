// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "unit/support/solid_setup.hpp"

namespace percolith::simulation {
namespace {

using test::value_of;

const test::Grid block_grid{.columns = 6, .rows = 6};

mesh::GmshMesh notched_block() {
  mesh::GmshMesh mesh = test::make_grid(block_grid);
  test::add_row_curve(block_grid, mesh, "notch", 3, 2, 4);
  return mesh;
}

/// A pump at a notch inside of an elastic block that fluid cannot leave.
Setup pumped() {
  Setup setup = test::solid_setup();
  setup.model.physics = Physics::coupled;
  setup.time.scheme = Scheme::explicit_;
  Material& rock = setup.material["sandstone"];
  rock.joints = RockJoints::elastic;
  rock.rock.permeability = {1e-13, 1e-13, 0.0};
  rock.rock.porosity = 0.2;
  material::Fracture& notch = setup.fracture["notch"].fracture;
  setup.fracture["notch"].groups = {"notch"};
  notch.initial_aperture = 1e-3;
  notch.minimum_aperture = 1e-4;
  notch.exchange = 1e-8;
  setup.source["pump"].fractures = {"notch"};
  setup.boundary["rim"] = test::on("left");
  setup.boundary["rim"].fixed = true;
  setup.damping.local = 0.2;
  setup.time.end = 3e-3;
  setup.output.fields = false;
  return setup;
}

/// The same in rock that the pump breaks, at an energy of mode 1 in J/m2.
Setup pumped_to_break(double energy) {
  Setup setup = pumped();
  Material& rock = setup.material["sandstone"];
  rock.joints = RockJoints::breakable;
  rock.strength.tensile_strength = 1e6;
  rock.strength.mode_1_energy = energy;
  setup.new_cracks = NewCracks{setup.fracture["notch"].fracture};
  setup.source["pump"].rate = Schedule::constant(5e-2);
  return setup;
}

/// The row of the history nearest to a time, s.
const HistoryRow& row_at(const std::vector<HistoryRow>& history, double time) {
  return *std::min_element(history.begin(), history.end(),
                           [&](const HistoryRow& a, const HistoryRow& b) {
                             return std::abs(a.time - time) < std::abs(b.time - time);
                           });
}

TEST(CoupledRuns, AWellIsShutInAndFlowsBack) {
  simulation::Setup setup = pumped();
  setup.source["pump"].rate = {
      {0.0, 1e-3, 1.001e-3, 2e-3, 2.001e-3}, {2e-2, 2e-2, 0.0, 0.0, -1e-2}, Interpolation::linear};
  test::SolidRecorder recorder;
  const Summary summary = test::run(setup, notched_block(), recorder);
  const auto injected = [&](double time) {
    return value_of(row_at(recorder.history, time).mechanics, "source.pump.volume_m2");
  };
  const auto pressure = [&](double time) {
    return row_at(recorder.history, time).maximum_crack_pressure.value();
  };
  // The integral of the schedule; a step takes the rate at its end.
  const double pumped_in = 2e-2 * 1e-3 + 0.5 * 2e-2 * 1e-6;
  EXPECT_NEAR(injected(1.1e-3), pumped_in, 1e-3 * pumped_in);
  EXPECT_EQ(injected(1.1e-3), injected(2e-3));
  EXPECT_NEAR(injected(3e-3), pumped_in - 1e-2 * 0.9995e-3, 1e-3 * pumped_in);
  EXPECT_GT(pressure(1e-3), pressure(1.9e-3));
  EXPECT_GT(pressure(1.9e-3), pressure(2.9e-3));
  EXPECT_LT(row_at(recorder.history, 3e-3).balance.relative_error, 1e-13);
  EXPECT_EQ(summary.end_time, 3e-3);
  ASSERT_EQ(summary.peak_pressures.size(), 1u);
  const PeakPressure& peak = summary.peak_pressures[0];
  EXPECT_EQ(peak.name, "source.pump");
  EXPECT_EQ(peak.pressure,
            value_of(row_at(recorder.history, peak.time).mechanics, "source.pump.pressure_Pa"));
  for (const HistoryRow& row : recorder.history) {
    EXPECT_LE(value_of(row.mechanics, "source.pump.pressure_Pa"), peak.pressure);
  }
}

/// Fluid leaves the cracks through their faces alone, and stays in the pores: what they hold more
/// than at the start is the integral of the flows through all faces.
TEST(CoupledRuns, WhatLeaksIsWhatThePoresHoldMore) {
  simulation::Setup setup = pumped();
  setup.source["pump"].rate = Schedule::constant(2e-2);
  test::SolidRecorder recorder;
  (void)test::run(setup, notched_block(), recorder);
  const HistoryRow& first = recorder.history.front();
  const double in_cracks_at_first = value_of(first.mechanics, "crack_fluid_m2");
  const double in_pores_at_first = first.balance.in_place - in_cracks_at_first;
  ASSERT_EQ(value_of(first.mechanics, "leaked_m2"), 0.0);
  for (const HistoryRow& row : recorder.history) {
    const double in_pores = row.balance.in_place - value_of(row.mechanics, "crack_fluid_m2");
    EXPECT_NEAR(value_of(row.mechanics, "leaked_m2"), in_pores - in_pores_at_first,
                1e-13 * in_pores);
  }
  const HistoryRow& last = recorder.history.back();
  const double leaked = value_of(last.mechanics, "leaked_m2");
  EXPECT_GT(leaked, 0.01 * last.balance.in);
  EXPECT_LT(leaked, last.balance.in);
}

/// Under in-situ stress on all sides nothing holds a block; it stays in place all the same, and
/// what holds it there bears next to nothing.
TEST(CoupledRuns, ABlockUnderInSituStressOnAllSidesIsHeldInPlace) {
  simulation::Setup setup = pumped();
  setup.damping = {};
  setup.boundary.clear();
  setup.boundary["rim"] = test::on("left");
  setup.boundary["rim"].groups = {"left", "right", "bottom", "top"};
  setup.boundary["rim"].in_situ = true;
  setup.in_situ = InSitu{};
  setup.in_situ->stress_xx = -12e6;
  setup.in_situ->stress_yy = -8e6;
  setup.time.scheme = Scheme::quasi_static;
  setup.time.end = 60.0;
  setup.time.tolerance = 1e-3;
  setup.material["sandstone"].rock.permeability = {1e-18, 1e-18, 0.0};
  setup.source["pump"].rate = Schedule::constant(1e-6);
  test::SolidRecorder recorder;
  const Summary summary = test::run(setup, notched_block(), recorder);
  EXPECT_EQ(summary.end_time, 60.0);
  const HistoryRow& last = recorder.history.back();
  EXPECT_GT(last.maximum_crack_pressure, 1e6);
  EXPECT_LT(last.balance.relative_error, 1e-12);
  for (const char* reaction :
       {"held_in_place.reaction_x_N_per_m", "held_in_place.reaction_y_N_per_m"}) {
    EXPECT_LT(std::abs(value_of(last.mechanics, reaction)), 1e-4 * 12e6) << reaction;
  }
}

/// A slow step that breaks rock takes long: what is at work, how far and with how many cracks is
/// told while it lasts.
TEST(CoupledRuns, ProgressTellsWhatALongStepIsAt) {
  simulation::Setup setup = pumped_to_break(10.0);
  setup.damping = {};
  Material& rock = setup.material["sandstone"];
  rock.rock.permeability = {1e-18, 1e-18, 0.0};
  rock.strength.tensile_strength = 1e5;
  setup.new_cracks->fracture.exchange = 1e-13;
  setup.source["pump"].rate = Schedule::constant(2e-5);
  setup.boundary["rim"].groups = {"left", "right", "bottom", "top"};
  setup.time.scheme = Scheme::quasi_static;
  setup.time.end = 30.0;
  setup.time.step = 30.0;
  setup.time.tolerance = 1e-2;
  setup.time.balance_tolerance = 1e-2;
  test::SolidRecorder recorder;
  (void)test::run(setup, notched_block(), recorder);
  ASSERT_FALSE(recorder.events.empty());
  std::set<std::string> deeds;
  std::int64_t most = 0;
  double latest = 0.0;
  for (const Progress& progress : recorder.progress) {
    if (progress.step == 0) {
      deeds.insert(progress.limited_by);
      most = std::max(most, progress.broken_joints.value_or(0));
      EXPECT_GE(progress.time, 0.0);
      EXPECT_LT(progress.time, 30.0);
      latest = std::max(latest, progress.time);
    }
  }
  EXPECT_EQ(deeds, (std::set<std::string>{"cracks run", "damped motion to rest",
                                          "fluid and rock settle"}));
  EXPECT_GE(most, std::ssize(recorder.events));
  EXPECT_GT(latest, 0.0);
}

/// A probe along the way of a crack reads dry rock until the crack has come, and the crack then.
TEST(CoupledRuns, ProbesFollowACrackThatGrows) {
  simulation::Setup setup = pumped_to_break(10.0);
  Probe along;
  along.from = {2.0 / 6.0 + 0.01, 0.5};
  along.to = {0.99, 0.5};
  along.points = 12;
  along.in = Domain::crack;
  setup.probe["along"] = along;
  setup.output.interval = 1e-4;
  setup.time.end = 2e-3;
  test::SolidRecorder recorder;
  const Summary summary = test::run(setup, notched_block(), recorder);
  ASSERT_FALSE(recorder.events.empty());
  EXPECT_TRUE(
      std::any_of(summary.warnings.begin(), summary.warnings.end(), [](const std::string& warning) {
        return warning.starts_with("probe.along: no crack is open at 5 of 12 points when the run "
                                   "starts; they read dry");
      }));
  const ProbeSample& first = recorder.probes.front().front();
  const ProbeSample& last = recorder.probes.back().front();
  ASSERT_EQ(first.columns, (std::vector<std::string>{"pressure_Pa", "saturation", "aperture_m",
                                                     "flux_x_m2_per_s", "flux_y_m2_per_s"}));
  const auto wet = [](const ProbeSample& sample) {
    return std::count_if(sample.rows.begin(), sample.rows.end(), [](const ProbeRow& row) {
      EXPECT_EQ(row.values[1] > 0.0, row.values[2] > 0.0) << "saturation goes with an aperture";
      return row.values[1] > 0.0;
    });
  };
  EXPECT_EQ(first.rows.size(), 12u);
  EXPECT_EQ(last.rows.size(), 12u);
  EXPECT_EQ(wet(first), 7);
  EXPECT_GT(wet(last), 7);
}

/// What a check foresees is the step that the run comes down to when thin cracks have opened.
TEST(CoupledRuns, CheckForeseesTheStepOfThinCracks) {
  simulation::Setup setup = pumped_to_break(1.0);
  setup.new_cracks->fracture.initial_aperture = 1e-5;
  setup.new_cracks->fracture.minimum_aperture = 1e-6;
  setup.output.history_interval = 1e-9;
  setup.time.end = 1e-3;
  const char* const name = "step once new cracks are there, before they widen (s)";
  const double foreseen = value_of(Simulation(setup, notched_block()).check().mechanics, name);
  test::SolidRecorder recorder;
  (void)test::run(setup, notched_block(), recorder);
  double shortest = setup.time.end;
  for (const Progress& progress : recorder.progress) {
    shortest = std::min(shortest, progress.step_size);
  }
  ASSERT_FALSE(recorder.events.empty());
  EXPECT_GT(recorder.progress.front().step_size, 2.0 * foreseen);
  EXPECT_LT(shortest, 1.5 * foreseen);
  EXPECT_GT(shortest, 0.5 * foreseen);
  setup.new_cracks->fracture.initial_aperture = 1e-2;
  const auto wide = Simulation(setup, notched_block()).check().mechanics;
  EXPECT_TRUE(
      std::none_of(wide.begin(), wide.end(), [&](const auto& e) { return e.first == name; }));
}

TEST(CoupledRuns, NothingRestsWhileAPumpRuns) {
  simulation::Setup setup = pumped();
  setup.time.stop_ratio = 5e-2;
  setup.damping.local = 0.7;
  setup.time.end = 5e-3;
  setup.source["pump"].rate = Schedule::constant(1e-3);
  test::SolidRecorder running;
  EXPECT_FALSE(test::run(setup, notched_block(), running).reached_rest);
  // The same well shut in comes to rest once its pressure has fallen to that of the rock.
  setup.fracture["notch"].fracture.exchange = 1e-6;
  setup.source["pump"].rate = {{0.0, 1e-4}, {1e-2, 0.0}, Interpolation::linear};
  setup.time.end = 1.0;
  test::SolidRecorder shut_in;
  const Summary summary = test::run(setup, notched_block(), shut_in);
  EXPECT_TRUE(summary.reached_rest);
  EXPECT_LT(summary.end_time, 1.0);
}

/// A notch that the sides press shut.
simulation::Setup squeezed_shut(double minimum_aperture) {
  simulation::Setup setup = pumped();
  setup.source.clear();
  setup.fracture["notch"].fracture.initial_aperture = 5e-6;
  setup.fracture["notch"].fracture.minimum_aperture = minimum_aperture;
  setup.fracture["notch"].fracture.exchange = 1e-9;
  setup.boundary["rim"] = test::on("bottom");
  setup.boundary["rim"].fixed = true;
  setup.boundary["top"] = test::on("top");
  setup.boundary["top"].normal_pressure = {{0.0, 5e-4}, {0.0, 2e8}, Interpolation::linear};
  setup.time.end = 1e-3;
  return setup;
}

TEST(CoupledRuns, ACrackPressedShutKeepsItsLeastRoom) {
  test::SolidRecorder recorder;
  const Summary summary = test::run(squeezed_shut(5e-7), notched_block(), recorder);
  EXPECT_EQ(summary.end_time, 1e-3);
  const HistoryRow& last = recorder.history.back();
  // Of its two joints the ends in the middle are shut, those at the tips cannot close.
  const double half = 0.5 * value_of(last.mechanics, "crack_length_m");
  EXPECT_NEAR(value_of(last.mechanics, "crack_volume_m2"), half * (5e-7 + 5e-6), 1e-12);
  EXPECT_LT(last.balance.relative_error, 1e-13);
}

TEST(CoupledRuns, ACrackWithoutAnyRoomIsNamed) {
  test::SolidRecorder recorder;
  try {
    (void)test::run(squeezed_shut(0.0), notched_block(), recorder);
    FAIL() << "fluid without room was computed";
  } catch (const SolverError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("the crack node with the least room, an aperture of"), std::string::npos)
        << said;
    EXPECT_NE(said.find("minimum_aperture"), std::string::npos) << said;
  }
}

TEST(CoupledRuns, ASteadyStartWithTooMuchSuctionTellsWhatHelps) {
  simulation::Setup setup = pumped();
  setup.initial.steady = true;
  setup.source["pump"].rate = Schedule::constant(-1e-2);
  setup.boundary["drain"] = test::on("right");
  setup.boundary["drain"].pressure = Schedule::constant(1e5);
  test::SolidRecorder recorder;
  try {
    (void)test::run(setup, notched_block(), recorder);
    FAIL() << "suction below the cavitation pressure was found";
  } catch (const SolverError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("the rock would drain there. Start from initial.pressure"),
              std::string::npos)
        << said;
    EXPECT_EQ(said.find("time.scheme"), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace percolith::simulation
