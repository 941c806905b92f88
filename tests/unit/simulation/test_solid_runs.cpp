// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/solid_build.hpp"
#include "percolith/simulation/solid_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "unit/support/solid_setup.hpp"

namespace percolith::simulation {
namespace {

using test::value_of;

const test::Grid irregular_grid{.columns = 4, .rows = 4, .jitter = 0.2};

/// The largest displacement of the last frame, m.
double largest_displacement(const Frame& frame) {
  double largest = 0.0;
  for (const Point& u : std::get<std::vector<Point>>(frame.matrix.point_fields.at(0).values)) {
    largest = std::max(largest, std::hypot(u.x, u.y));
  }
  return largest;
}

TEST(SolidRuns, InSituStressStaysAtRest) {
  simulation::Setup setup = test::solid_setup();
  setup.model.gravity = 9.81;
  setup.in_situ = InSitu{-6e6, -8e6, 1e6, 10000.0, 2500.0 * 9.81, 0.0, 1.0, -5e6, 3e5};
  for (const char* side : {"left", "right", "top"}) {
    setup.boundary[side] = test::on(side);
    setup.boundary[side].in_situ = true;
  }
  setup.boundary["bottom"] = test::on("bottom");
  setup.boundary["bottom"].fixed = true;
  for (const RockJoints joints : {RockJoints::elastic, RockJoints::breakable}) {
    setup.material["sandstone"].joints = joints;
    test::SolidRecorder recorder;
    const Summary summary = test::run(setup, test::make_grid(irregular_grid), recorder);
    EXPECT_LT(largest_displacement(recorder.frames.back()), 1e-13);
    EXPECT_LT(value_of(summary.mechanics, "unbalanced_ratio"), 1e-10);
    EXPECT_NEAR(test::cell_values(recorder.frames.back(), "stress_xy_Pa")[3], 1e6, 1.0);
    const MatrixFrame& matrix = recorder.frames.back().matrix;
    double height = 0.0;
    for (const auto point : matrix.triangles[3]) {
      height += matrix.points[static_cast<std::size_t>(point)].y / 3.0;
    }
    EXPECT_NEAR(test::cell_values(recorder.frames.back(), "stress_zz_Pa")[3],
                -5e6 + 3e5 * (height - 1.0), 1.0);
    // The bottom carries what the in-situ stress presses it with.
    EXPECT_NEAR(value_of(summary.last.mechanics, "boundary.bottom.reaction_y_N_per_m"),
                8e6 + 2500.0 * 9.81, 1.0);
    EXPECT_TRUE(recorder.events.empty());
  }
}

/// A block that is held on its left and pulled to the right until it breaks.
simulation::Setup stretched() {
  simulation::Setup setup = test::solid_setup();
  setup.boundary["left"] = test::on("left");
  setup.boundary["left"].fixed = true;
  setup.boundary["right"] = test::on("right");
  setup.boundary["right"].velocity_x = Schedule::constant(1.0);
  setup.time.end = 3e-3;
  return setup;
}

TEST(SolidRuns, AStretchedBlockBreaksWithEventsThatAreAccountedFor) {
  simulation::Setup setup = stretched();
  setup.time.safety = 0.2;
  test::SolidRecorder recorder;
  const Summary summary = test::run(setup, test::make_grid(irregular_grid), recorder);
  ASSERT_FALSE(recorder.events.empty());
  EXPECT_EQ(value_of(summary.mechanics, "broken_joints"),
            static_cast<double>(recorder.events.size()));
  EXPECT_GE(value_of(summary.mechanics, "fragments"), 2.0);
  EXPECT_NEAR(value_of(summary.mechanics, "fragment_area_m2"), 1.0, 1e-12);
  EXPECT_LT(value_of(summary.mechanics, "largest_fragment_area_m2"), 1.0);
  EXPECT_LT(value_of(summary.mechanics, "energy_error"), 1e-3);
  double time = 0.0;
  double released = 0.0;
  for (const BreakEvent& event : recorder.events) {
    EXPECT_GE(event.time, time);
    EXPECT_GT(event.step, 0);
    EXPECT_EQ(event.material, "sandstone");
    EXPECT_NEAR(event.magnitude, 2.0 / 3.0 * (std::log10(event.released_energy) - 4.8), 1e-12);
    EXPECT_LE(event.released_energy, 1.001 * event.length * 900.0);
    EXPECT_GE(event.released_energy, 0.999 * event.length * 400.0);
    time = event.time;
    released += event.released_energy;
  }
  EXPECT_EQ(recorder.events.front().mode, BreakMode::tensile);
  for (const auto& [mode, name] :
       {std::pair{BreakMode::tensile, "tensile"}, std::pair{BreakMode::shear, "shear"},
        std::pair{BreakMode::mixed, "mixed"}}) {
    EXPECT_EQ(value_of(summary.mechanics, std::string("broken_joints_") + name),
              static_cast<double>(std::count_if(
                  recorder.events.begin(), recorder.events.end(),
                  [wanted = mode](const BreakEvent& event) { return event.mode == wanted; })));
  }
  EXPECT_GT(value_of(summary.mechanics, "fracture_J_per_m"), 0.9 * released);
  // The broken joints are in the picture of the cracks.
  const CrackFrame& cracks = recorder.frames.back().cracks;
  EXPECT_GE(cracks.segments.size(), recorder.events.size());
}

TEST(SolidRuns, PeaksOfReactionsAreThoseOfTheHistory) {
  simulation::Setup setup = stretched();
  test::SolidRecorder recorder;
  const Summary summary = test::run(setup, test::make_grid(irregular_grid), recorder);
  ASSERT_EQ(summary.peak_reactions.size(), 2u);
  for (const PeakReaction& peak : summary.peak_reactions) {
    double largest = 0.0;
    for (const HistoryRow& row : recorder.history) {
      const double reaction = value_of(row.mechanics, peak.name + ".reaction_x_N_per_m");
      if (row.time == peak.x_time) {
        EXPECT_EQ(reaction, peak.x);
      }
      largest = std::max(largest, std::abs(reaction));
    }
    EXPECT_EQ(std::abs(peak.x), largest);
  }
  EXPECT_EQ(summary.peak_reactions[0].name, "boundary.left");
  EXPECT_LT(summary.peak_reactions[0].x, 0.0);
  EXPECT_GT(summary.peak_reactions[0].x_time, 0.0);
  EXPECT_LT(summary.peak_reactions[0].x_time, summary.end_time);
}

TEST(SolidRuns, TwoRunsAreEqual) {
  simulation::Setup setup = test::solid_setup();
  setup.boundary["left"] = test::on("left");
  setup.boundary["left"].fixed = true;
  setup.boundary["right"] = test::on("right");
  setup.boundary["right"].velocity_x = Schedule::constant(1.0);
  setup.material["sandstone"].weibull_modulus = 5.0;
  setup.time.end = 2e-3;
  test::SolidRecorder first;
  test::SolidRecorder second;
  const std::string hash = test::run(setup, test::make_grid(irregular_grid), first).state_hash;
  EXPECT_EQ(test::run(setup, test::make_grid(irregular_grid), second).state_hash, hash);
  EXPECT_EQ(first.events.size(), second.events.size());
  setup.material["sandstone"].weibull_seed = 2;
  test::SolidRecorder third;
  EXPECT_NE(test::run(setup, test::make_grid(irregular_grid), third).state_hash, hash);
}

TEST(SolidRuns, StopsAtRest) {
  simulation::Setup setup = test::solid_setup();
  setup.boundary["bottom"] = test::on("bottom");
  setup.boundary["bottom"].roller = true;
  setup.boundary["left"] = test::on("left");
  setup.boundary["left"].roller = true;
  setup.boundary["top"] = test::on("top");
  setup.boundary["top"].traction_y = Schedule::constant(-2e6);
  setup.damping.local = 0.7;
  setup.time.end = 1.0;
  setup.time.stop_ratio = 1e-6;
  for (const RockJoints joints : {RockJoints::elastic, RockJoints::breakable}) {
    setup.material["sandstone"].joints = joints;
    test::SolidRecorder recorder;
    const Summary summary = test::run(setup, test::make_grid(irregular_grid), recorder);
    EXPECT_TRUE(summary.reached_rest);
    EXPECT_LT(summary.end_time, 1.0);
    EXPECT_NEAR(value_of(summary.last.mechanics, "boundary.bottom.reaction_y_N_per_m"), 2e6, 20.0);
    if (joints == RockJoints::elastic) {
      for (const double s : test::cell_values(recorder.frames.back(), "stress_yy_Pa")) {
        EXPECT_NEAR(s, -2e6, 1e-3 * 2e6);
      }
      // Plane strain: sigma_zz = nu sigma_yy.
      EXPECT_NEAR(test::cell_values(recorder.frames.back(), "stress_zz_Pa")[0], -0.5e6, 1e3);
    }
  }
}

TEST(SolidRuns, WhatIsStillMovedIsNotAtRest) {
  simulation::Setup setup = test::solid_setup();
  setup.material["sandstone"].joints = RockJoints::elastic;
  setup.boundary["bottom"] = test::on("bottom");
  setup.boundary["bottom"].fixed = true;
  setup.boundary["top"] = test::on("top");
  setup.boundary["top"].velocity_y = Schedule::constant(-1e-6);
  setup.damping.local = 0.7;
  setup.time.end = 0.05;
  setup.time.stop_ratio = 0.5;
  test::SolidRecorder recorder;
  const Summary summary = test::run(setup, test::make_grid(irregular_grid), recorder);
  EXPECT_FALSE(summary.reached_rest);
  EXPECT_DOUBLE_EQ(summary.end_time, 0.05);
}

TEST(SolidRuns, ContactAlongAFractureHasItsFriction) {
  simulation::Setup setup = test::solid_setup();
  setup.fracture["fault"].groups = {"level"};
  setup.fracture["fault"].strength.friction_angle = 0.1;
  const SolidStart start = build_solid(setup, test::plain_mesh());
  const mechanics::Model& model = start.dynamics.model();
  const std::vector<double> friction = contact_properties(setup, model).friction;
  std::vector<double> expected(friction.size(), std::tan(0.6));
  for (const mechanics::ClosedJoint& closed : model.closed) {
    for (const auto& side : model.mesh.joint[at(closed.joint)].corner) {
      expected[at(mesh::triangle_of(side[0]))] = std::tan(0.1);
    }
  }
  EXPECT_FALSE(model.closed.empty());
  EXPECT_EQ(friction, expected);
}

TEST(SolidRuns, AnExcavationComesToRest) {
  simulation::Setup setup = test::solid_setup();
  mesh::GmshMesh file = test::make_grid({.columns = 6, .rows = 6});
  file.regions = {"rock", "tunnel"};
  for (std::size_t t = 0; t < file.triangles.size(); ++t) {
    Point centre{};
    for (const auto p : file.triangles[t]) {
      centre = centre + (1.0 / 3) * file.points[static_cast<std::size_t>(p)];
    }
    const bool inside = std::abs(centre.x - 0.5) < 1.0 / 6 && std::abs(centre.y - 0.5) < 1.0 / 6;
    file.triangle_region[t] = inside ? 1 : 0;
  }
  setup.material["sandstone"].regions = {"rock", "tunnel"};
  setup.in_situ = InSitu{-1e6, -1e6};
  for (const char* side : {"left", "right", "bottom", "top"}) {
    setup.boundary[side] = test::on(side);
    setup.boundary[side].fixed = true;
  }
  setup.excavation["tunnel"] = {{"tunnel"}, 1e-4, 5e-4};
  setup.probe["line"].from = std::array<double, 2>{0.1, 0.5};
  setup.probe["line"].to = std::array<double, 2>{0.51, 0.5};
  setup.probe["line"].points = 2;
  setup.damping.local = 0.7;
  setup.time.end = 1.0;
  setup.time.stop_ratio = 1e-5;
  test::SolidRecorder recorder;
  const Summary summary = test::run(setup, file, recorder);
  EXPECT_TRUE(summary.reached_rest);
  EXPECT_GT(summary.end_time, 6e-4);
  const auto values_of = [](const std::vector<ProbeSample>& samples, std::size_t row) {
    return samples.at(0).rows.at(row).values;
  };
  const auto is_number = [](double value) { return !std::isnan(value); };
  for (const double value : values_of(recorder.probes.back(), 1)) {
    EXPECT_TRUE(std::isnan(value));
  }
  for (const auto& values :
       {values_of(recorder.probes.front(), 1), values_of(recorder.probes.back(), 0)}) {
    EXPECT_TRUE(std::all_of(values.begin(), values.end(), is_number));
  }
  EXPECT_EQ(recorder.frames.front().matrix.triangles.size(), 72u);
  EXPECT_EQ(recorder.frames.back().matrix.triangles.size(), 64u);
  EXPECT_GT(largest_displacement(recorder.frames.back()), 1e-6);
  EXPECT_TRUE(recorder.events.empty());
}

TEST(SolidRuns, ProbesAndHistoryTellTheMotion) {
  simulation::Setup setup = test::solid_setup();
  setup.model.gravity = 10.0;
  setup.probe["middle"].point = std::array<double, 2>{0.5, 0.5};
  setup.output.interval = 5e-4;
  test::SolidRecorder recorder;
  test::run(setup, test::make_grid(irregular_grid), recorder);
  ASSERT_EQ(recorder.probe_times, (std::vector<double>{0.0, 5e-4, 1e-3}));
  const ProbeSample& last = recorder.probes.back().at(0);
  EXPECT_EQ(last.columns.at(1), "displacement_y_m");
  EXPECT_NEAR(last.rows.at(0).values.at(1), -0.5 * 10.0 * 1e-6, 1e-9 * 1e-6);
  EXPECT_NEAR(value_of(recorder.history.back().mechanics, "residual_J_per_m"), 0.0,
              1e-9 * value_of(recorder.history.back().mechanics, "gravity_J_per_m"));
}

TEST(SolidRuns, AThrownBodyFliesAndARigidOneLeads) {
  simulation::Setup setup = test::solid_setup();
  mesh::GmshMesh file = test::make_grid(irregular_grid);
  const mesh::GmshMesh other = test::make_grid({.columns = 2, .rows = 2, .origin = {1.5, 0.0}});
  const auto shift = static_cast<std::int32_t>(file.points.size());
  file.points.insert(file.points.end(), other.points.begin(), other.points.end());
  for (auto t : other.triangles) {
    for (auto& p : t) {
      p += shift;
    }
    file.triangles.push_back(t);
    file.triangle_region.push_back(1);
  }
  file.regions = {"rock", "hammer"};
  setup.material["sandstone"].regions = {"rock", "hammer"};
  setup.body["thrown"].regions = {"rock"};
  setup.body["thrown"].initial_velocity_y = 3.0;
  setup.body["hammer"].regions = {"hammer"};
  setup.body["hammer"].rigid = true;
  setup.body["hammer"].velocity_x = Schedule::constant(1.0);
  setup.probe["rock"].point = std::array<double, 2>{0.5, 0.5};
  setup.probe["hammer"].point = std::array<double, 2>{2.0, 0.5};
  test::SolidRecorder recorder;
  test::run(setup, file, recorder);
  EXPECT_NEAR(value_of(recorder.history.front().mechanics, "kinetic_J_per_m"), 0.5 * 2500.0 * 9.0,
              1e-6);
  for (const ProbeSample& sample : recorder.probes.back()) {
    const std::vector<double>& v = sample.rows.at(0).values;
    EXPECT_NEAR(v.at(0), sample.name == "rock" ? 0.0 : 1e-3, 1e-12);
    EXPECT_NEAR(v.at(1), sample.name == "rock" ? 3e-3 : 0.0, 1e-12);
  }
}

TEST(SolidRuns, ARollerHoldsAcrossAnInclinedEdge) {
  // The block turned by 30 degrees slides along its lower side.
  mesh::GmshMesh file = test::make_grid(irregular_grid);
  const double c = std::cos(0.5235987755982988);
  for (Point& p : file.points) {
    p = {c * p.x - 0.5 * p.y, 0.5 * p.x + c * p.y};
  }
  simulation::Setup setup = test::solid_setup();
  setup.model.gravity = 9.81;
  setup.boundary["bottom"] = test::on("bottom");
  setup.boundary["bottom"].roller = true;
  setup.probe["foot"].point = std::array<double, 2>{0.5 * c, 0.25};
  test::SolidRecorder recorder;
  test::run(setup, file, recorder);
  const std::vector<double>& v = recorder.probes.back().at(0).rows.at(0).values;
  EXPECT_LT(std::abs(v.at(0)), 0.5 * 9.81 * 1e-6);
  EXPECT_NEAR(-0.5 * v.at(0) + c * v.at(1), 0.0, 1e-15);
  EXPECT_LT(v.at(0), 0.0);
}

TEST(SolidRuns, MassScalingTakesItsStep) {
  simulation::Setup setup = test::solid_setup();
  setup.model.gravity = 9.81;
  const auto file = test::make_grid(irregular_grid);
  const double limit = Simulation(setup, file).check().limits.back().step;
  setup.time.mass_scaling_step = 3.0 * limit;
  const CheckReport report = Simulation(setup, file).check();
  EXPECT_NEAR(report.limits.back().step, 3.0 * limit, 1e-9 * limit);
  EXPECT_GT(value_of(report.mechanics, "added mass over mass"), 1.0);
  ASSERT_FALSE(report.warnings.empty());
  EXPECT_NE(report.warnings.back().find("only states of rest keep their meaning"),
            std::string::npos);
}

TEST(SolidRuns, RunsAtTheFullLimitAndEndsOnTime) {
  simulation::Setup setup = test::solid_setup();
  setup.time.safety = 1.0;
  setup.time.end = 1.2345e-3;
  setup.boundary["left"] = test::on("left");
  setup.boundary["left"].velocity_x = Schedule::constant(1e-3);
  test::SolidRecorder recorder;
  const Summary summary = test::run(setup, test::make_grid(irregular_grid), recorder);
  EXPECT_EQ(summary.end_time, 1.2345e-3);
  EXPECT_LT(value_of(summary.mechanics, "kinetic_J_per_m"), 5000.0 * 1e-6);
  EXPECT_TRUE(recorder.events.empty());
}

TEST(SolidRuns, WeibullStrengthsHaveMeanOne) {
  simulation::Setup setup = test::solid_setup();
  setup.material["sandstone"].weibull_modulus = 4.0;
  const auto mesh = mesh::build_mesh(test::make_grid({.columns = 60, .rows = 60}));
  const auto from = solid_ingredients(setup, mesh);
  ASSERT_EQ(from.joint_factor.size(), mesh.joint.size());
  double mean = 0.0;
  double square = 0.0;
  for (const double f : from.joint_factor) {
    mean += f / static_cast<double>(from.joint_factor.size());
    square += f * f / static_cast<double>(from.joint_factor.size());
  }
  EXPECT_NEAR(mean, 1.0, 0.01);
  // Variance Gamma(1 + 2/m)/Gamma(1 + 1/m)^2 - 1.
  EXPECT_NEAR(square - mean * mean, std::tgamma(1.5) / std::pow(std::tgamma(1.25), 2) - 1.0, 4e-3);
}

TEST(BValue, OfMagnitudesThatFollowTheLaw) {
  std::mt19937 random(1);
  std::exponential_distribution<double> above(1.3 * std::log(10.0));
  std::vector<double> magnitudes(20000);
  std::generate(magnitudes.begin(), magnitudes.end(), [&] { return -3.05 + above(random); });
  EXPECT_NEAR(b_value(magnitudes), 1.3, 0.04);
  magnitudes.resize(19);
  EXPECT_TRUE(std::isnan(b_value(magnitudes)));
}

}  // namespace
}  // namespace percolith::simulation
