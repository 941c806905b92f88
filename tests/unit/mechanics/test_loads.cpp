// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/loads.hpp"
#include "percolith/mechanics/strain.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/support/solid_model.hpp"

namespace percolith::mechanics {
namespace {

using test::at;

const test::Grid grid{.columns = 4, .rows = 4, .jitter = 0.2};

Point sum_of(const Model& model) {
  Point sum{};
  test::for_each_corner(model.mesh, [&](Index, Index c) {
    sum = sum + Point{model.loads.fx[at(c)], model.loads.fy[at(c)]};
  });
  return sum;
}

TEST(Loads, TractionActsOnTheUndeformedEdges) {
  Model model = test::make_solid(test::make_grid(grid));
  test::displace(model, [](Point p) { return Point{p.x, 2.0 * p.y}; });
  LoadList list;
  list.traction.push_back(
      {test::edges_of(model, "right"), Schedule::constant(3.0), Schedule{{0.0, 2.0}, {0.0, 8.0}}});
  LoadSet loads(model.mesh, list);
  loads.apply(model);
  EXPECT_NEAR(sum_of(model).x, 3.0, 1e-14);
  EXPECT_NEAR(sum_of(model).y, 0.0, 1e-14);
  model.motion.time = 1.0;
  loads.apply(model);
  EXPECT_NEAR(sum_of(model).x, 3.0, 1e-14);
  EXPECT_NEAR(sum_of(model).y, 4.0, 1e-14);
  EXPECT_EQ(loads.next_break(0.0), 2.0);
  // The corner of the block has half of its edge.
  const auto corners = model.mesh.vertex_corners.row(test::vertex_at(model.mesh, {1.0, 1.0}));
  double there = 0.0;
  for (const Index c : corners) {
    there += model.loads.fx[at(c)];
  }
  EXPECT_NEAR(there, 3.0 / 8.0, 1e-14);
}

TEST(Loads, PressureFollowsTheDeformedEdges) {
  Model model = test::make_solid(test::make_grid(grid));
  LoadList list;
  list.pressure.push_back({test::edges_of(model, "right"), Schedule::constant(5.0)});
  LoadSet loads(model.mesh, list);
  loads.apply(model);
  EXPECT_NEAR(sum_of(model).x, -5.0, 1e-14);
  // Stretched twofold along the edge, then turned by a right angle: it pushes downwards.
  test::displace(model, [](Point p) { return Point{-2.0 * p.y, p.x} - p; });
  loads.apply(model);
  EXPECT_NEAR(sum_of(model).x, 0.0, 1e-13);
  EXPECT_NEAR(sum_of(model).y, -10.0, 1e-13);
}

TEST(Loads, PressureAllRoundPushesNowhere) {
  Model model = test::make_solid(test::make_grid(grid));
  LoadList list;
  std::vector<Index> all;
  for (Index e = 0; e < static_cast<Index>(model.mesh.boundary.size()); ++e) {
    all.push_back(e);
  }
  list.pressure.push_back({all, Schedule::constant(5.0)});
  LoadSet loads(model.mesh, list);
  test::displace(model, [](Point p) { return Point{0.3 * p.x * p.y, -0.2 * p.x}; });
  loads.apply(model);
  EXPECT_NEAR(sum_of(model).x, 0.0, 1e-13);
  EXPECT_NEAR(sum_of(model).y, 0.0, 1e-13);
}

TEST(Loads, PointAndConstantForcesAdd) {
  Model model = test::make_solid(test::make_grid(grid));
  LoadList list;
  list.point.push_back({3, 0.25, Schedule{{0.0, 1.0}, {0.0, 8.0}}, Schedule::constant(-4.0)});
  list.constant.push_back({3, {10.0, 0.0}});
  LoadSet loads(model.mesh, list);
  model.motion.time = 0.5;
  for (int i = 0; i < 3; ++i) {
    loads.apply(model);
    EXPECT_DOUBLE_EQ(model.loads.fx[3], 11.0);
    EXPECT_DOUBLE_EQ(model.loads.fy[3], -1.0);
  }
  EXPECT_EQ(loads.next_break(0.0), 1.0);
}

TEST(Loads, SupportsOfWhatWasTakenOutFade) {
  const FadingSupport support{2.0, 4.0, {}};
  EXPECT_EQ(support.left(1.0), 1.0);
  EXPECT_EQ(support.left(2.0), 1.0);
  EXPECT_DOUBLE_EQ(support.left(3.0), 0.75);
  EXPECT_EQ(support.left(6.0), 0.0);
  EXPECT_EQ(support.left(7.0), 0.0);
  EXPECT_EQ((FadingSupport{2.0, 0.0, {}}.left(2.1)), 0.0);
}

TEST(Loads, InSituStressIsInEquilibriumWithItsTractions) {
  // Uniform stress all round; joints carry it from the start.
  const Tensor stress{-4e6, -7e6, 1.5e6};
  for (const JointState joints : {JointState::tied, JointState::bonded, JointState::closed}) {
    test::SolidOptions options{.joints = joints};
    options.kind.residual_friction = 2.0;
    Model model = test::make_solid(test::make_grid(grid), options);
    set_initial_stress(model, [&](Point) { return stress; });
    LoadList list;
    for (const mesh::BoundaryEdge& edge : model.mesh.boundary) {
      const Point along =
          model.mesh.vertex[at(edge.vertex[1])] - model.mesh.vertex[at(edge.vertex[0])];
      for (const Index c : edge.corner) {
        list.constant.push_back({c, 0.5 * (stress * clockwise(along))});
      }
    }
    Dynamics dynamics = test::make_dynamics(std::move(model), std::move(list));
    test::advance(dynamics, 0.9 * test::stable_step(dynamics), 200);
    test::for_each_corner(dynamics.model().mesh, [&](Index t, Index c) {
      EXPECT_LT(test::distance(test::displacement(dynamics.model(), c), {}), 1e-15);
      EXPECT_NEAR(triangle_stress(dynamics.model(), t).plane.xy, 1.5e6, 1.0);
    });
    EXPECT_LT(dynamics.unbalanced_ratio(), 1e-9);
    EXPECT_LT(std::abs(dynamics.energy(Execution()).friction), 1e-9);
  }
}

/// A bar 8 m long with an absorbing right end; a pulse starts at the left.
Dynamics bar_with_pulse(JointState joints, double poisson_ratio, Point direction) {
  const test::Grid bar{.columns = 160, .rows = 2, .width = 8.0, .height = 0.1};
  Model model = test::make_solid(
      test::make_grid(bar), {.rock = test::elastic_rock(10e9, poisson_ratio), .joints = joints});
  LoadList list;
  list.dashpot = absorbing_edges(model, test::edges_of(model, "right"));
  // A plane wave: corners move along one direction only, as in an endless plane.
  std::vector<Held> held;
  test::hold_where(
      model, [](Point) { return true; }, clockwise(direction), 0, held);
  SupportSet supports(model, {{"plane", PrescribedMotion::Kind::velocity, Schedule{}}}, held);
  const auto speed = material::wave_speeds(model.material[0].rock, model.plane);
  const double c = direction.x == 1.0 ? speed.compression : speed.shear;
  // Travelling to the right: v = -c du/dx.
  const auto shape = [](double x) { return std::exp(-4.0 * (x - 3.0) * (x - 3.0)); };
  test::displace(model, [&](Point p) { return 1e-6 * shape(p.x) * direction; });
  test::set_velocity(
      model, [&](Point p) { return 1e-6 * c * 8.0 * (p.x - 3.0) * shape(p.x) * direction; });
  return test::make_dynamics(std::move(model), std::move(list), std::move(supports));
}

TEST(Loads, AnAbsorbingBoundaryLetsPlaneWavesOut) {
  for (const Point direction : {Point{1.0, 0.0}, Point{0.0, 1.0}}) {
    Dynamics dynamics = bar_with_pulse(JointState::tied, 0.25, direction);
    const auto speed =
        material::wave_speeds(dynamics.model().material[0].rock, dynamics.model().plane);
    const double c = direction.x == 1.0 ? speed.compression : speed.shear;
    const double dt = 0.9 * test::stable_step(dynamics);
    const auto steps = static_cast<int>(8.0 / c / dt);
    test::advance(dynamics, dt, 10);
    const double start = dynamics.energy(Execution()).kinetic;
    test::advance(dynamics, dt, steps);
    const EnergyBalance e = dynamics.energy(Execution());
    // 1 % of the amplitude is 1e-4 of the energy.
    EXPECT_LT(e.kinetic + e.elastic, 2e-4 * start) << direction.x;
    EXPECT_NEAR(e.absorbed, 2 * start, 0.02 * start);
    EXPECT_LT(std::abs(e.residual), 1e-3 * start);
  }
}

TEST(Loads, AbsorbingBoundariesAllowTheStepOfTheRock) {
  for (const JointState joints : {JointState::tied, JointState::bonded}) {
    Model model = test::make_solid(test::make_grid(grid), {.joints = joints});
    LoadList list;
    for (const char* side : {"left", "right", "bottom", "top"}) {
      const auto dashpots = absorbing_edges(model, test::edges_of(model, side));
      list.dashpot.insert(list.dashpot.end(), dashpots.begin(), dashpots.end());
    }
    test::set_velocity(model, [](Point p) { return Point{p.y * p.x, 0.3 - p.x}; });
    Dynamics dynamics = test::make_dynamics(std::move(model), std::move(list));
    const double start = dynamics.energy(Execution()).kinetic;
    test::advance(dynamics, 0.99 * test::stable_step(dynamics), 3000);
    EXPECT_LT(dynamics.energy(Execution()).kinetic, 0.01 * start);
  }
}

}  // namespace
}  // namespace percolith::mechanics
