// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "unit/support/setup.hpp"

namespace percolith::simulation {
namespace {

struct Rest {
  const char* name;
  Scheme scheme;
  Point origin{};
  double size = 1.0;
  seepage::PoreJoints joints = seepage::PoreJoints::tied;
  double exchange = 1e-9;
};

const Rest cases[] = {
    {"implicit", Scheme::implicit},
    {"explicit", Scheme::explicit_},
    {"steady", Scheme::steady},
    {"implicit_infinite_exchange", Scheme::implicit, {}, 1.0, seepage::PoreJoints::tied, INFINITY},
    {"implicit_finite_joints", Scheme::implicit, {}, 1.0, seepage::PoreJoints::finite},
    {"explicit_finite_joints", Scheme::explicit_, {}, 1.0, seepage::PoreJoints::finite},
    {"implicit_far_away", Scheme::implicit, {3000.0, -1000.0}, 1000.0},
    {"explicit_far_away", Scheme::explicit_, {3000.0, -1000.0}, 1000.0},
    {"steady_far_away", Scheme::steady, {3000.0, -1000.0}, 1000.0},
};

class Hydrostatic : public testing::TestWithParam<Rest> {};

TEST_P(Hydrostatic, StaysAtRestInMatrixAndCracks) {
  const Rest& rest = GetParam();
  const auto mesh = test::plain_mesh({.columns = 12,
                                      .rows = 12,
                                      .width = rest.size,
                                      .height = rest.size,
                                      .origin = rest.origin,
                                      .jitter = 0.25,
                                      .mixed_diagonals = true});
  const double top = rest.origin.y + rest.size;
  simulation::Setup setup = test::plain_setup();
  setup.model.gravity = 9.81;
  setup.model.pore_joints = rest.joints;
  setup.model.head_datum = 17.0;
  setup.boundary.clear();
  setup.boundary["roof"].groups = {"top"};
  setup.boundary["roof"].head = Schedule::constant(top + 5.0 - 17.0);
  setup.initial.head = top + 5.0 - 17.0;
  setup.fracture["upright"] = test::fracture_group("upright", 1e-4, rest.exchange);
  setup.fracture["level"] = test::fracture_group("level", 2e-4, rest.exchange);
  setup.time.scheme = rest.scheme;
  setup.time.end = rest.scheme == Scheme::explicit_ ? 2e-5 * rest.size : 1e4;
  setup.time.maximum_step = 2e3;
  test::Recorder recorder;
  const Summary summary = test::run(setup, mesh, recorder);
  if (rest.scheme != Scheme::steady) {
    EXPECT_GT(summary.steps, 4);
    EXPECT_LT(summary.last.balance.relative_error, 1e-13);
  }
  const double speed = 1e-13 * 9810.0 / 1e-3;
  for (const Frame& frame : recorder.frames) {
    for (const Point& q : frame.matrix.flux) {
      ASSERT_LT(std::hypot(q.x, q.y), 1e-9 * speed) << frame.time;
    }
    for (std::size_t s = 0; s < frame.cracks.flux.size(); ++s) {
      // Along a crack the speed under its own weight is a^2 rho g/(12 mu).
      const double a = frame.cracks.aperture[s];
      ASSERT_LT(std::abs(frame.cracks.flux[s]), 1e-9 * a * a * a / 12.0 * 9810.0 / 1e-3)
          << frame.time;
    }
    for (std::size_t i = 0; i < frame.matrix.points.size(); ++i) {
      ASSERT_NEAR(frame.matrix.pressure[i], 9810.0 * (top + 5.0 - frame.matrix.points[i].y),
                  1e-9 * 9810.0 * rest.size);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, Hydrostatic, testing::ValuesIn(cases),
                         [](const auto& rest) { return std::string(rest.param.name); });

TEST(WaterTable, BelowItTheRockIsFullAboveItHoldsWhatIsSaid) {
  simulation::Setup setup = test::plain_setup();
  setup.model.gravity = 9.81;
  setup.boundary.clear();
  setup.initial.water_table = 0.4;
  setup.initial.saturation = 0.3;
  setup.fracture["upright"] = test::fracture_group("upright", 1e-4, 1e-9);
  setup.initial.crack_saturation = 0.1;
  setup.time.scheme = Scheme::implicit;
  setup.time.end = 1e-9;
  test::Recorder recorder;
  test::run(setup, test::plain_mesh(), recorder);
  const Frame& start = recorder.frames.front();
  for (std::size_t i = 0; i < start.matrix.points.size(); ++i) {
    const double y = start.matrix.points[i].y;
    EXPECT_NEAR(start.matrix.pressure[i], 9810.0 * std::max(0.4 - y, 0.0), 1e-9);
    EXPECT_NEAR(start.matrix.saturation[i], y < 0.4 ? 1.0 : 0.3, 1e-14);
  }
  for (std::size_t i = 0; i < start.cracks.points.size(); ++i) {
    EXPECT_NEAR(start.cracks.saturation[i], start.cracks.points[i].y < 0.4 ? 1.0 : 0.1, 1e-14);
  }
}

TEST(Initial, PrescribedPressuresHoldFromTheStartAndAreNotBooked) {
  simulation::Setup setup = test::plain_setup();
  setup.time.scheme = Scheme::implicit;
  setup.time.end = 1.0;
  setup.initial.pressure = 3e4;
  setup.fracture["upright"] = test::fracture_group("upright", 1e-4, 1e-9);
  setup.initial.crack_pressure = 7e4;
  test::Recorder recorder;
  test::run(setup, test::plain_mesh(), recorder);
  const Frame& start = recorder.frames.front();
  for (std::size_t i = 0; i < start.matrix.points.size(); ++i) {
    const double x = start.matrix.points[i].x;
    EXPECT_NEAR(start.matrix.pressure[i], x == 0.0 ? 1e5 : x == 1.0 ? 0.0 : 3e4, 1e-9);
  }
  for (const double p : start.cracks.pressure) {
    EXPECT_NEAR(p, 7e4, 1e-9);
  }
  EXPECT_EQ(recorder.history.front().balance.in, 0.0);
  EXPECT_EQ(recorder.history.front().balance.out, 0.0);
}

}  // namespace
}  // namespace percolith::simulation
