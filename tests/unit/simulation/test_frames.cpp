// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "unit/support/setup.hpp"

namespace percolith::simulation {
namespace {

using test::plain_setup;

/// A tight wall right across the flow.
Setup walled_setup() {
  simulation::Setup setup = plain_setup();
  setup.fracture["wall"] = test::fracture_group("wall", 1e-5, 1e-10);
  return setup;
}

mesh::GmshMesh walled_mesh() {
  auto file = test::make_grid(test::plain_grid);
  test::add_column_curve(test::plain_grid, file, "wall", 4, 0, 8);
  return file;
}

TEST(Frames, PressureIsDiscontinuousAcrossACrack) {
  test::Recorder recorder;
  test::run(walled_setup(), walled_mesh(), recorder);
  ASSERT_EQ(recorder.frames.size(), 1u);
  const MatrixFrame& matrix = recorder.frames[0].matrix;
  // Nine points on the wall are there twice.
  EXPECT_EQ(matrix.points.size(), 81u + 9u);
  EXPECT_EQ(matrix.triangles.size(), 128u);
  EXPECT_EQ(matrix.region.size(), 128u);
  EXPECT_TRUE(matrix.head.empty());
  const double flux = 1e5 / (1e-3 / 1e-13 + 2.0 / 1e-10);
  for (std::size_t t = 0; t < matrix.triangles.size(); ++t) {
    double x = 0.0;
    for (const auto p : matrix.triangles[t]) {
      x += matrix.points[static_cast<std::size_t>(p)].x / 3.0;
    }
    for (const auto p : matrix.triangles[t]) {
      const auto i = static_cast<std::size_t>(p);
      const double resistance = matrix.points[i].x * 1e10 + (x > 0.5 ? 2.0 / 1e-10 : 0.0);
      EXPECT_NEAR(matrix.pressure[i], 1e5 - flux * resistance, 1e-6);
      EXPECT_EQ(matrix.saturation[i], 1.0);
    }
    EXPECT_NEAR(matrix.flux[t].x, flux, 1e-11 * flux);
    EXPECT_NEAR(matrix.flux[t].y, 0.0, 1e-11 * flux);
  }
  const CrackFrame& cracks = recorder.frames[0].cracks;
  EXPECT_EQ(cracks.points.size(), 9u);
  EXPECT_EQ(cracks.segments.size(), 8u);
  for (std::size_t i = 0; i < cracks.points.size(); ++i) {
    EXPECT_EQ(cracks.points[i].x, 0.5);
    EXPECT_NEAR(cracks.pressure[i], 5e4, 1e-6);
  }
  for (std::size_t s = 0; s < cracks.segments.size(); ++s) {
    EXPECT_EQ(cracks.aperture[s], 1e-5);
    EXPECT_EQ(cracks.group[s], 0);
  }
}

TEST(Frames, HeadCountsFromItsDatumAndCracksCarryTheirFlux) {
  simulation::Setup setup = plain_setup();
  setup.model.gravity = 9.81;
  setup.model.head_datum = -100.0;
  setup.boundary.clear();
  for (const auto& [name, head] : {std::pair{"left", 120.0}, std::pair{"right", 110.0}}) {
    setup.boundary[name].groups = {name};
    setup.boundary[name].head = Schedule::constant(head);
  }
  setup.fracture["drain"] = test::fracture_group("drain", 1e-4);
  auto file = test::make_grid(test::plain_grid);
  test::add_row_curve(test::plain_grid, file, "drain", 4, 0, 8);
  test::Recorder recorder;
  const Summary summary = test::run(setup, file, recorder);
  const Frame& frame = recorder.frames.at(0);
  for (std::size_t i = 0; i < frame.matrix.points.size(); ++i) {
    const Point& p = frame.matrix.points[i];
    EXPECT_NEAR(frame.matrix.head[i], 120.0 - 10.0 * p.x, 1e-8);
    EXPECT_NEAR(frame.matrix.pressure[i], 9810.0 * (frame.matrix.head[i] - p.y - 100.0), 1e-4);
  }
  const double crack_flux = 1e-12 / 12e-3 * 9810.0 * 10.0;
  for (std::size_t s = 0; s < frame.cracks.segments.size(); ++s) {
    const auto& [a, b] = frame.cracks.segments[s];
    const bool rightwards = frame.cracks.points[static_cast<std::size_t>(a)].x <
                            frame.cracks.points[static_cast<std::size_t>(b)].x;
    EXPECT_NEAR(frame.cracks.flux[s], rightwards ? crack_flux : -crack_flux, 1e-9 * crack_flux);
    EXPECT_NEAR(frame.cracks.head[static_cast<std::size_t>(a)],
                120.0 - 10.0 * frame.cracks.points[static_cast<std::size_t>(a)].x, 1e-8);
  }
  const double total = crack_flux + 1e-13 / 1e-3 * 9810.0 * 10.0;
  EXPECT_NEAR(summary.throughput, total, 1e-9 * total);
  EXPECT_NEAR(summary.last.rate.at("boundary.left"), total, 1e-9 * total);
  EXPECT_NEAR(summary.last.rate.at("boundary.right"), -total, 1e-9 * total);
}

TEST(Frames, FieldsCanBeLeftOut) {
  simulation::Setup setup = plain_setup();
  setup.output.fields = false;
  setup.probe["gauge"].point = {0.5, 0.5};
  test::Recorder recorder;
  test::run(setup, test::plain_mesh(), recorder);
  EXPECT_TRUE(recorder.frames.empty());
  EXPECT_EQ(recorder.probes.size(), 1u);
}

TEST(Probes, PointsAndLinesInTheMatrix) {
  simulation::Setup setup = plain_setup();
  setup.probe["gauge"].point = {0.3, 0.71};
  setup.probe["line"].from = {-0.5, 0.4};
  setup.probe["line"].to = {0.5, 0.4};
  setup.probe["line"].points = 11;
  test::Recorder recorder;
  test::run(setup, test::plain_mesh(), recorder);
  ASSERT_EQ(recorder.probes.at(0).size(), 2u);
  const ProbeSample& gauge = recorder.probes[0][0];
  EXPECT_EQ(gauge.name, "gauge");
  EXPECT_EQ(gauge.columns, (std::vector<std::string>{"pressure_Pa", "saturation", "flux_x_m_per_s",
                                                     "flux_y_m_per_s"}));
  ASSERT_EQ(gauge.rows.size(), 1u);
  EXPECT_NEAR(gauge.rows[0].values[0], 7e4, 1e-6);
  EXPECT_EQ(gauge.rows[0].values[1], 1.0);
  EXPECT_NEAR(gauge.rows[0].values[2], 1e-5, 1e-16);
  EXPECT_NEAR(gauge.rows[0].values[3], 0.0, 1e-16);
  // The half of the line outside of the rock is left out.
  const ProbeSample& line = recorder.probes[0][1];
  ASSERT_EQ(line.rows.size(), 6u);
  for (std::size_t i = 0; i < line.rows.size(); ++i) {
    EXPECT_NEAR(line.rows[i].place.x, 0.1 * static_cast<double>(i), 1e-12);
    EXPECT_NEAR(line.rows[i].values[0], 1e5 * (1.0 - line.rows[i].place.x), 1e-6);
  }
}

TEST(Probes, OnCracksAndWithHead) {
  simulation::Setup setup = plain_setup();
  setup.model.gravity = 9.81;
  setup.model.head_datum = 2.0;
  setup.boundary.clear();
  setup.boundary["all"].groups = {"left", "right"};
  setup.boundary["all"].head = Schedule::constant(5.0);
  setup.fracture["fault"] = test::fracture_group("upright", 3e-5);
  setup.probe["in_crack"].point = {0.52, 0.6};
  setup.probe["in_crack"].in = Domain::crack;
  setup.probe["near_tip"].from = {0.5, 0.0};
  setup.probe["near_tip"].to = {0.5, 1.0};
  setup.probe["near_tip"].in = Domain::crack;
  setup.probe["near_tip"].points = 9;
  test::Recorder recorder;
  test::run(setup, test::plain_mesh(), recorder);
  const ProbeSample& sample = recorder.probes.at(0).at(0);
  EXPECT_EQ(sample.columns,
            (std::vector<std::string>{"pressure_Pa", "head_m", "saturation", "aperture_m",
                                      "flux_x_m2_per_s", "flux_y_m2_per_s"}));
  EXPECT_EQ(sample.rows.at(0).place, (Point{0.52, 0.6}));
  EXPECT_NEAR(sample.rows[0].values[0], 9810.0 * (5.0 + 2.0 - 0.6), 1e-6);
  EXPECT_NEAR(sample.rows[0].values[2], 1.0, 0.0);
  EXPECT_EQ(sample.rows[0].values[3], 3e-5);
  // The crack runs from 0.25 to 1: of nine points every eighth of a metre, seven lie on it.
  EXPECT_EQ(recorder.probes[0].at(1).rows.size(), 7u);
}

}  // namespace
}  // namespace percolith::simulation
