// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/checkpoints.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "unit/support/solid_setup.hpp"

namespace percolith::simulation {
namespace {

/// Keeps every checkpoint as bytes, and tells what was reported after each.
class Keeper : public test::SolidRecorder {
public:
  struct Kept {
    std::string bytes;
    std::size_t rows, frames, events;
  };
  void on_checkpoint(const Checkpoint& checkpoint) override {
    std::string bytes;
    StateWriter writer([&](std::string_view part) { bytes += part; });
    checkpoint.state(writer);
    kept.push_back({bytes, history.size(), frames.size(), events.size()});
  }
  void on_resume(double time, std::int64_t /*step*/) override { resumed.push_back(time); }
  std::vector<Kept> kept;
  std::vector<double> resumed;
};

std::vector<double> numbers(const HistoryRow& row) {
  std::vector<double> values{row.time,
                             static_cast<double>(row.step),
                             row.step_size,
                             row.minimum_pressure,
                             row.maximum_pressure,
                             row.minimum_saturation,
                             row.balance.in,
                             row.balance.out,
                             row.balance.stored,
                             row.balance.error};
  for (const auto& [name, value] : row.mechanics) {
    values.push_back(value);
  }
  return values;
}

/// Goes on from every checkpoint of a run to the next two, which must be the same:
/// some of the state is there between two steps only, when joints have just broken.
void expect_same_next_steps(const Setup& setup, const mesh::GmshMesh& mesh, const Keeper& whole) {
  for (std::size_t k = 0; k + 2 < whole.kept.size(); ++k) {
    Simulation simulation(setup, mesh);
    Keeper rest;
    StateReader reader(whole.kept[k].bytes, "checkpoint");
    simulation.resume(reader, rest, [&] { return rest.kept.size() == 2; });
    ASSERT_GE(rest.kept.size(), 2U);
    ASSERT_EQ(rest.kept[0].bytes, whole.kept[k + 1].bytes) << k;
    ASSERT_EQ(rest.kept[1].bytes, whole.kept[k + 2].bytes) << k;
  }
}

/// A run in parts, looked at in between, comes to the bits and reports of one that was not.
void expect_same_in_parts(const Setup& setup, const mesh::GmshMesh& mesh, const Keeper& whole,
                          const Summary& expected) {
  Simulation simulation(setup, mesh);
  Keeper parts;
  simulation.begin(parts);
  while (simulation.advance(parts, test::never, {.steps = 3}) == Reached::pause) {
    EXPECT_EQ(simulation.look().time, simulation.time());
    EXPECT_EQ(simulation.frame().step, simulation.steps());
  }
  const Summary summary = simulation.summary();
  EXPECT_EQ(summary.state_hash, expected.state_hash);
  EXPECT_EQ(summary.mechanics, expected.mechanics);
  ASSERT_EQ(parts.history.size(), whole.history.size());
  for (std::size_t i = 0; i < parts.history.size(); ++i) {
    EXPECT_EQ(numbers(parts.history[i]), numbers(whole.history[i])) << i;
  }
  EXPECT_EQ(parts.frames.size(), whole.frames.size());
}

/// Goes on from checkpoints of a run, about `count` of them, and compares all that follows.
void expect_same_from_checkpoints(const Setup& setup, const mesh::GmshMesh& mesh,
                                  std::size_t count) {
  Keeper whole;
  const Summary expected = test::run(setup, mesh, whole);
  ASSERT_GE(whole.kept.size(), count);
  expect_same_in_parts(setup, mesh, whole, expected);
  expect_same_next_steps(setup, mesh, whole);
  const std::size_t stride = whole.kept.size() / count;
  for (std::size_t k = 0; k < whole.kept.size(); k += stride) {
    const Keeper::Kept& from = whole.kept[k];
    Simulation simulation(setup, mesh);
    Keeper rest;
    StateReader reader(from.bytes, "checkpoint");
    ASSERT_TRUE(simulation.resume(reader, rest, test::never));
    EXPECT_TRUE(reader.rest().empty());
    const Summary summary = simulation.summary();
    EXPECT_EQ(summary.state_hash, expected.state_hash) << k;
    EXPECT_EQ(summary.steps, expected.steps);
    EXPECT_EQ(summary.iterations, expected.iterations);
    EXPECT_EQ(summary.rejected_steps, expected.rejected_steps);
    EXPECT_EQ(summary.mechanics, expected.mechanics);
    ASSERT_EQ(summary.peak_reactions.size(), expected.peak_reactions.size());
    for (std::size_t i = 0; i < summary.peak_reactions.size(); ++i) {
      EXPECT_EQ(summary.peak_reactions[i].x, expected.peak_reactions[i].x);
      EXPECT_EQ(summary.peak_reactions[i].x_time, expected.peak_reactions[i].x_time);
    }
    ASSERT_EQ(summary.peak_pressures.size(), expected.peak_pressures.size());
    for (std::size_t i = 0; i < summary.peak_pressures.size(); ++i) {
      EXPECT_EQ(summary.peak_pressures[i].name, expected.peak_pressures[i].name);
      EXPECT_EQ(summary.peak_pressures[i].pressure, expected.peak_pressures[i].pressure);
      EXPECT_EQ(summary.peak_pressures[i].time, expected.peak_pressures[i].time);
    }
    ASSERT_EQ(from.rows + rest.history.size(), whole.history.size());
    for (std::size_t i = 0; i < rest.history.size(); ++i) {
      EXPECT_EQ(numbers(rest.history[i]), numbers(whole.history[from.rows + i])) << k << " " << i;
    }
    EXPECT_EQ(from.frames + rest.frames.size(), whole.frames.size());
    EXPECT_EQ(from.events + rest.events.size(), whole.events.size());
    EXPECT_EQ(rest.resumed.size(), 1U);
    ASSERT_EQ(from.bytes.empty(), false);
    // Later checkpoints are the same too.
    ASSERT_EQ(k + 1 + rest.kept.size(), whole.kept.size());
    for (std::size_t i = 0; i < rest.kept.size(); ++i) {
      ASSERT_EQ(rest.kept[i].bytes, whole.kept[k + 1 + i].bytes) << k << " " << i;
    }
  }
}

const test::Grid grid{.columns = 4, .rows = 4, .jitter = 0.2};

TEST(Checkpoints, ABreakingBlockGoesOnToTheSameBits) {
  simulation::Setup setup = test::solid_setup();
  setup.boundary["left"] = test::on("left");
  setup.boundary["left"].fixed = true;
  setup.boundary["right"] = test::on("right");
  setup.boundary["right"].velocity_x = {{0.0, 1e-3, 2e-3, 3e-3}, {1.0, 1.0, -3.0, 2.0}};
  setup.boundary["top"] = test::on("top");
  setup.boundary["top"].absorbing = true;
  setup.time.end = 4e-3;
  setup.time.safety = 0.2;
  setup.damping.local = 0.1;
  setup.output.interval = 5e-4;
  setup.output.history_interval = 1e-4;
  setup.output.checkpoint_interval = 1e-7;
  expect_same_from_checkpoints(setup, test::make_grid(grid), 12);
}

TEST(Checkpoints, TiedRockUnderGravityThatComesToRestGoesOnToTheSameBits) {
  simulation::Setup setup = test::solid_setup();
  setup.model.gravity = 9.81;
  setup.material["sandstone"].joints = RockJoints::elastic;
  setup.boundary["bottom"] = test::on("bottom");
  setup.boundary["bottom"].fixed = true;
  setup.damping.local = 0.7;
  setup.time.end = 1.0;
  setup.time.stop_ratio = 1e-3;
  setup.output.checkpoint_interval = 1e-5;
  expect_same_from_checkpoints(setup, test::make_grid(grid), 7);
}

/// Rock that breaks under its load while its middle is taken out.
TEST(Checkpoints, AnExcavationGoesOnToTheSameBits) {
  simulation::Setup setup = test::solid_setup();
  setup.model.gravity = 9.81;
  setup.in_situ = InSitu{-6e6, -8e6, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  setup.material["middle"] = setup.material["sandstone"];
  setup.material["middle"].regions = {"middle"};
  setup.boundary["left"] = test::on("left");
  setup.boundary["left"].roller = true;
  setup.boundary["bottom"] = test::on("bottom");
  setup.boundary["bottom"].fixed = true;
  setup.boundary["top"] = test::on("top");
  setup.boundary["top"].normal_pressure = {{0.0, 1e-4, 3e-4}, {8e6, 8e6, 2e8}};
  setup.excavation["hole"] = {{"middle"}, 1.5e-3, 4e-4};
  setup.time.end = 2.5e-3;
  setup.time.safety = 0.3;
  setup.output.checkpoint_interval = 1e-8;
  mesh::GmshMesh mesh = test::make_grid(grid);
  mesh.regions.push_back("middle");
  for (const std::size_t t : {11U, 12U, 13U, 18U}) {
    mesh.triangle_region[t] = 1;
  }
  expect_same_from_checkpoints(setup, mesh, 25);
}

/// Faces that slide under pressure until contact takes over from their joints.
TEST(Checkpoints, FacesThatSlideFarGoOnToTheSameBits) {
  simulation::Setup setup = test::solid_setup();
  setup.material["sandstone"].strength.tensile_strength = 1e8;
  setup.material["sandstone"].strength.cohesion = 5e6;
  setup.material["sandstone"].strength.mode_2_energy = 90.0;
  setup.boundary["bottom"] = test::on("bottom");
  setup.boundary["bottom"].fixed = true;
  setup.boundary["top"] = test::on("top");
  setup.boundary["top"].normal_pressure = Schedule::constant(1e7);
  setup.boundary["top"].velocity_x = Schedule::constant(15.0);
  setup.damping.local = 0.2;
  setup.time.end = 8e-3;
  setup.time.safety = 0.5;
  setup.output.checkpoint_interval = 1e-8;
  expect_same_from_checkpoints(setup, test::make_grid({.columns = 3, .rows = 2}), 5);
}

/// Water that comes and goes through one rock that may empty.
Setup filling(Scheme scheme) {
  simulation::Setup setup = test::plain_setup();
  setup.model.gravity = 9.81;
  setup.fluid.cavitation_pressure = 0.0;
  setup.initial.pressure = 0.0;
  setup.material["sandstone"].rock.permeability = {1e-11, 1e-11, 0.0};
  setup.initial.saturation = 0.9;
  setup.boundary["inlet"].pressure = Schedule{{0.0, 200.0, 300.0}, {2e4, 2e4, 0.0}};
  setup.boundary["outlet"].pressure.reset();
  setup.boundary["outlet"].seepage_face = Schedule::constant(0.0);
  setup.time.scheme = scheme;
  return setup;
}

TEST(Checkpoints, ImplicitFlowGoesOnToTheSameBits) {
  simulation::Setup setup = filling(Scheme::implicit);
  setup.time.end = 400.0;
  setup.output.interval = 50.0;
  setup.output.checkpoint_interval = 1e-3;
  expect_same_from_checkpoints(setup, test::make_grid(grid), 10);
}

TEST(Checkpoints, SaturatedImplicitFlowGoesOnWithoutTheFactorsOfItsMatrix) {
  simulation::Setup setup = test::plain_setup();
  setup.time.scheme = Scheme::implicit;
  setup.time.end = 2e-2;
  setup.output.checkpoint_interval = 1e-7;
  expect_same_from_checkpoints(setup, test::make_grid(grid), 8);
}

TEST(Checkpoints, ExplicitFlowGoesOnToTheSameBits) {
  simulation::Setup setup = filling(Scheme::explicit_);
  setup.time.end = 0.04;
  setup.output.interval = 0.01;
  setup.output.checkpoint_interval = 1e-7;
  expect_same_from_checkpoints(setup, test::make_grid(grid), 10);
}

TEST(Checkpoints, FlowThatSettlesEndsAtTheSameStep) {
  for (const Scheme scheme : {Scheme::implicit, Scheme::explicit_}) {
    simulation::Setup setup = test::plain_setup();
    setup.time.scheme = scheme;
    setup.time.end = 50.0;
    setup.time.stop_ratio = 1e-3;
    setup.output.history_interval = 0.5;
    setup.output.checkpoint_interval = scheme == Scheme::implicit ? 1e-4 : 0.1;
    test::Recorder recorder;
    const Summary summary = test::run(setup, test::make_grid(grid), recorder);
    EXPECT_TRUE(summary.reached_rest);
    EXPECT_LT(summary.end_time, setup.time.end);
    expect_same_from_checkpoints(setup, test::make_grid(grid), 8);
  }
}

struct Way {
  FluidEnters fluid_enters;
  PoreFlow pore_flow;
  double exchange;
  double rate;
};

/// Water that breaks the rock, some of which is taken out on the way.
TEST(Checkpoints, RockThatFluidBreaksGoesOnToTheSameBits) {
  for (const Way& way : {Way{FluidEnters::broken, PoreFlow::explicit_, 1e-9, 0.2},
                         Way{FluidEnters::softening, PoreFlow::explicit_, 1e-9, 0.2},
                         Way{FluidEnters::broken, PoreFlow::implicit,
                             std::numeric_limits<double>::infinity(), 0.8}}) {
    simulation::Setup setup = test::solid_setup();
    setup.model.physics = Physics::coupled;
    setup.model.fluid_enters = way.fluid_enters;
    setup.time.pore_flow = way.pore_flow;
    for (const char* const name : {"sandstone", "middle"}) {
      Material& rock = setup.material[name];
      rock = setup.material["sandstone"];
      rock.rock.permeability = {1e-13, 1e-13, 0.0};
      rock.rock.porosity = 0.2;
      rock.strength.tensile_strength = 1e6;
      rock.strength.mode_1_energy = 20.0;
    }
    setup.material["middle"].regions = {"middle"};
    setup.new_cracks = NewCracks{};
    setup.new_cracks->fracture.exchange = way.exchange;
    setup.fracture["notch"].groups = {"notch"};
    setup.fracture["notch"].fracture.exchange = way.exchange;
    setup.source["pump"].fractures = {"notch"};
    setup.source["pump"].rate = Schedule::constant(way.rate);
    setup.boundary["left"] = test::on("left");
    setup.boundary["left"].seepage_face = Schedule::constant(0.0);
    setup.boundary["right"] = test::on("right");
    setup.boundary["right"].fixed = true;
    setup.excavation["hole"] = {{"middle"}, 3e-4, 1e-4, 1e5};
    setup.time.scheme = Scheme::explicit_;
    setup.time.end = 6e-4;
    setup.time.safety = 0.5;
    setup.output.interval = 1e-4;
    setup.output.checkpoint_interval = 1e-9;
    mesh::GmshMesh mesh = test::make_grid(grid);
    test::add_row_curve(grid, mesh, "notch", 2, 0, 2);
    mesh.regions.push_back("middle");
    for (const std::size_t t : {2U, 3U}) {
      mesh.triangle_region[t] = 1;
    }
    test::SolidRecorder recorder;
    test::run(setup, mesh, recorder);
    EXPECT_GT(test::value_of(recorder.history.back().mechanics, "crack_length_m"),
              test::value_of(recorder.history.front().mechanics, "crack_length_m"));
    expect_same_from_checkpoints(setup, mesh, 12);
  }
}

/// Slow injection into a notch of a block held on two sides.
Setup slow_injection(double strength, double rate) {
  simulation::Setup setup = test::solid_setup();
  setup.model.physics = Physics::coupled;
  setup.time.scheme = Scheme::quasi_static;
  Material& rock = setup.material["sandstone"];
  rock.rock.permeability = {1e-18, 1e-18, 0.0};
  rock.rock.porosity = 0.1;
  rock.strength.tensile_strength = strength;
  setup.new_cracks = NewCracks{};
  setup.new_cracks->fracture.exchange = 1e-13;
  setup.fracture["notch"].groups = {"notch"};
  setup.fracture["notch"].fracture.exchange = 1e-13;
  setup.source["pump"].fractures = {"notch"};
  setup.source["pump"].rate = Schedule::constant(rate);
  setup.boundary["right"] = test::on("right");
  setup.boundary["right"].fixed = true;
  setup.time.end = 300.0;
  setup.time.step = 75.0;
  setup.time.tolerance = 1e-2;
  setup.time.balance_tolerance = 1e-2;
  setup.output.checkpoint_interval = 1e-3;
  return setup;
}

mesh::GmshMesh notched() {
  mesh::GmshMesh mesh = test::make_grid(grid);
  test::add_row_curve(grid, mesh, "notch", 2, 0, 2);
  return mesh;
}

/// It keeps the pressures its iteration found beside the contents.
TEST(Checkpoints, SlowInjectionGoesOnToTheSameBits) {
  expect_same_from_checkpoints(slow_injection(5e6, 1e-8), notched(), 1);
}

/// Cracks that have opened since the start belong to what it goes on from.
TEST(Checkpoints, SlowInjectionThatHasBrokenTheRockGoesOnToTheSameBits) {
  simulation::Setup setup = slow_injection(1e5, 2e-5);
  setup.material["sandstone"].strength.mode_1_energy = 10.0;
  // Held on all sides, it does not break through.
  for (const char* const side : {"left", "top", "bottom"}) {
    setup.boundary[side] = test::on(side);
    setup.boundary[side].fixed = true;
  }
  setup.time.end = 60.0;
  setup.time.step = 30.0;
  Keeper whole;
  static_cast<void>(test::run(setup, notched(), whole));
  ASSERT_FALSE(whole.events.empty());
  for (const BreakEvent& event : whole.events) {
    EXPECT_GT(event.time, 0.0);
    EXPECT_LE(event.time, setup.time.end);
  }
  ASSERT_GT(whole.kept.size(), 0U);
  ASSERT_GT(whole.kept.front().events, 0U);
  expect_same_from_checkpoints(setup, notched(), 1);
}

/// Runs until `stop` and goes on; the whole must be as if it had not been stopped.
void expect_same_when_stopped(const Setup& setup, const std::function<bool()>& stop) {
  Keeper whole;
  const Summary expected = test::run(setup, notched(), whole);
  Simulation simulation(setup, notched());
  Keeper stopped;
  ASSERT_FALSE(simulation.run(stopped, stop));
  ASSERT_FALSE(stopped.kept.empty());
  // No moment is told twice.
  for (std::size_t i = 1; i < stopped.history.size(); ++i) {
    EXPECT_LT(stopped.history[i - 1].time, stopped.history[i].time);
  }
  Simulation again(setup, notched());
  Keeper rest;
  StateReader reader(stopped.kept.back().bytes, "checkpoint");
  ASSERT_TRUE(again.resume(reader, rest, test::never));
  const Summary summary = again.summary();
  EXPECT_EQ(summary.state_hash, expected.state_hash);
  EXPECT_EQ(summary.steps, expected.steps);
  EXPECT_EQ(summary.iterations, expected.iterations);
  EXPECT_EQ(stopped.kept.back().rows + rest.history.size(), whole.history.size());
}

TEST(Checkpoints, ARunThatIsLeftWhereItWaitsGoesOnToTheSameBits) {
  const simulation::Setup setup = slow_injection(5e6, 1e-8);
  Keeper whole;
  const Summary expected = test::run(setup, notched(), whole);
  Simulation simulation(setup, notched());
  Keeper left;
  simulation.begin(left);
  ASSERT_EQ(simulation.advance(left, test::never, {.steps = 2}), Reached::pause);
  simulation.leave(left);
  ASSERT_FALSE(left.kept.empty());
  Simulation again(setup, notched());
  Keeper rest;
  StateReader reader(left.kept.back().bytes, "checkpoint");
  ASSERT_TRUE(again.resume(reader, rest, test::never));
  EXPECT_EQ(again.summary().state_hash, expected.state_hash);
  EXPECT_EQ(left.kept.back().rows + rest.history.size(), whole.history.size());
}

/// It is asked thousands of times a step.
TEST(Checkpoints, SlowInjectionStopsInTheMidstOfAStep) {
  for (const int most : {10, 400}) {
    int asked = 0;
    expect_same_when_stopped(slow_injection(5e6, 1e-8), [&] { return ++asked == most; });
    EXPECT_EQ(asked, most);
  }
}

TEST(Checkpoints, SlowInjectionThatTakesMoreThanThereIsEndsAtOnce) {
  simulation::Setup setup = slow_injection(5e6, -1e-4);
  test::Recorder recorder;
  EXPECT_THROW(test::run(setup, notched(), recorder), SolverError);
  EXPECT_LE(recorder.history.size(), 2U);
}

TEST(Checkpoints, ARunThatStopsLeavesOneThatKnowsNothingOfItsLastReports) {
  simulation::Setup setup = test::plain_setup();
  setup.time.scheme = Scheme::implicit;
  setup.time.end = 2e-2;
  setup.output.history_interval = 1e-2;
  Keeper whole;
  static_cast<void>(test::run(setup, test::plain_mesh(), whole));
  Simulation simulation(setup, test::plain_mesh());
  Keeper stopped;
  EXPECT_FALSE(simulation.run(stopped, [&] { return stopped.progress.size() == 3; }));
  ASSERT_EQ(stopped.kept.size(), 1U);
  EXPECT_EQ(stopped.frames.size(), stopped.kept[0].frames + 1);
  EXPECT_EQ(stopped.history.size(), stopped.kept[0].rows + 1);
  Simulation again(setup, test::plain_mesh());
  Keeper rest;
  StateReader reader(stopped.kept[0].bytes, "checkpoint");
  EXPECT_TRUE(again.resume(reader, rest, test::never));
  EXPECT_EQ(again.summary().state_hash, [&] {
    Simulation uninterrupted(setup, test::plain_mesh());
    Keeper keeper;
    uninterrupted.run(keeper, test::never);
    return uninterrupted.summary().state_hash;
  }());
  EXPECT_EQ(stopped.kept[0].rows + rest.history.size(), whole.history.size());
}

TEST(Checkpoints, OfAnotherModelAreRefusedBeforeAnythingIsReported) {
  simulation::Setup setup = test::plain_setup();
  setup.time.scheme = Scheme::implicit;
  setup.time.end = 2e-2;
  setup.output.checkpoint_interval = 1e-3;
  Keeper whole;
  static_cast<void>(test::run(setup, test::make_grid(grid), whole));
  ASSERT_FALSE(whole.kept.empty());
  Simulation other(setup, test::plain_mesh());
  Keeper rest;
  StateReader reader(whole.kept[0].bytes, "checkpoint");
  try {
    other.resume(reader, rest, test::never);
    ADD_FAILURE() << "no error";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("checkpoint: run.model.tied: "), std::string::npos)
        << error.what();
  }
  EXPECT_TRUE(rest.resumed.empty());
  EXPECT_TRUE(rest.history.empty());
}

}  // namespace
}  // namespace percolith::simulation
