// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/coupling/motion_to_volume.hpp"
#include "percolith/mechanics/pressed_faces.hpp"
#include "percolith/mechanics/triangle.hpp"

#include <gtest/gtest.h>

#include <random>

#include "unit/support/coupled_model.hpp"

namespace percolith::coupling {
namespace {

using test::at;

/// Forces are the derivatives of volumes, so that pressure times volume is their work.
TEST(PressureForces, AreTheDerivativeOfTheAreaOfATriangle) {
  const Point a{1.0, 0.2};
  const Point b{0.3, 0.9};
  const double pressure = 3.0;
  const auto force = mechanics::pressure_forces(a, b, pressure);
  const auto area = [&](const std::array<Point, 3>& u) {
    return mechanics::area_growth(a, b, u[1] - u[0], u[2] - u[0]);
  };
  constexpr double h = 1e-6;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    std::array<Point, 3> more{};
    std::array<Point, 3> less{};
    more[corner].x = h;
    less[corner].x = -h;
    EXPECT_NEAR(force[corner].x, pressure * (area(more) - area(less)) / (2.0 * h), 1e-9);
    more[corner] = {0.0, h};
    less[corner] = {0.0, -h};
    EXPECT_NEAR(force[corner].y, pressure * (area(more) - area(less)) / (2.0 * h), 1e-9);
  }
}

TEST(AreaGrowth, KeepsTheDigitsOfSmallStrains) {
  const Point a{1.0, 0.0};
  const Point b{0.0, 1.0};
  EXPECT_NEAR(mechanics::area_growth(a, b, Point{1e-14, 0.0}, Point{0.0, 0.0}) / 0.5e-14, 1.0,
              1e-12);
}

test::CoupledOptions cracked() {
  test::CoupledOptions options;
  options.solid.curves = {{"middle", mechanics::JointState::closed}};
  options.prepare_water = [](seepage::Model& water) { test::break_curve(water, "middle"); };
  return options;
}

/// A block with a straight crack along its middle, y = 0.5.
mesh::GmshMesh block() {
  const test::Grid grid{.columns = 6, .rows = 6};
  mesh::GmshMesh file = test::make_grid(grid);
  test::add_row_curve(grid, file, "middle", 3, 0, 6);
  return file;
}

/// Lifts the upper half, more on the right, and measures the crack.
void lift(test::Coupled& coupled, double height) {
  mechanics::Model& rock = coupled.rock().model();
  test::for_each_corner(rock.mesh, [&](Index t, Index c) {
    const bool upper = test::centroid(rock.mesh, t).y > 0.5;
    rock.motion.uy[at(c)] = upper ? height * (1.0 + 0.3 * rock.mesh.place_of(c).x) : 0.0;
  });
  Execution execution;
  mechanics::measure_faces(rock, execution);
  std::vector<seepage::CrackOpening> openings;
  for (const mechanics::PressedFaces& faces : rock.pressed) {
    openings.push_back({faces.joint, faces.opening});
  }
  const std::vector<double> pressure = coupled.water().state.crack_pressure;
  seepage::open_cracks(coupled.water(), openings);
  coupled.water().state.crack_pressure = pressure;
}

/// Work on the faces up to the present place, J/m.
double press(test::Coupled& coupled) {
  mechanics::Model& rock = coupled.rock().model();
  const std::vector<double>& pressure = coupled.water().state.crack_pressure;
  for (mechanics::PressedFaces& faces : rock.pressed) {
    const auto& ends = rock.mesh.joint[at(faces.joint)].vertex;
    faces.pressure = {pressure[at(ends[0])], pressure[at(ends[1])]};
  }
  Execution execution;
  mechanics::press_faces(rock, execution);
  return rock.energy.fluid_work.total();
}

TEST(CrackPressure, WorksOnTheFacesAsTheVolumeOfTheCrackGrows) {
  test::Coupled coupled(block(), cracked());
  seepage::Model& water = coupled.water();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.5, 1.0);
  for (const Index v : water.cracks.open_nodes()) {
    water.state.crack_pressure[at(v)] = 1e6 * unit(random);
  }
  lift(coupled, 1e-6);
  const double start = press(coupled);
  const std::vector<double> before = water.crack.void_volume;
  lift(coupled, 2e-6);
  double by_volume = 0.0;
  for (const Index v : water.cracks.open_nodes()) {
    by_volume +=
        water.state.crack_pressure[at(v)] * (water.crack.void_volume[at(v)] - before[at(v)]);
  }
  EXPECT_NEAR((press(coupled) - start) / by_volume, 1.0, 1e-9);
}

/// At the reference stress a tenth of the aperture is left.
TEST(ClosureStress, ClosesAFractureToATenth) {
  test::CoupledOptions options = cracked();
  options.flow.fracture[0].closure_stress = 5e6;
  options.prepare_rock = [](mechanics::Model& rock) {
    mechanics::set_initial_stress(rock, [](const Point&) { return Tensor{0.0, -5e6, 0.0}; });
  };
  test::Coupled coupled(block(), options);
  Execution execution;
  take_volumes(coupled.model(), execution);
  for (const Index j : coupled.water().cracks.broken_joints()) {
    EXPECT_NEAR(coupled.water().crack.aperture[at(j)], 1e-5, 1e-12);
  }
}

TEST(PoreGrowth, IsBiotTimesTheGrowthOfTheTriangles) {
  test::CoupledOptions options;
  options.biot = 0.6;
  test::Coupled coupled(test::make_grid({.columns = 4, .rows = 4, .jitter = 0.2}), options);
  mechanics::Model& rock = coupled.rock().model();
  test::set_velocity(rock, [](const Point& p) { return Point{1e-3 * p.x, 0.0}; });
  coupled.advance(1);
  double growth = 0.0;
  for (const double g : rock.pores.growth) {
    growth += g;
  }
  const double dt = rock.motion.last_step;
  EXPECT_NEAR(growth / (0.6 * 1e-3 * dt), 1.0, 1e-3);
  double of_nodes = 0.0;
  for (const Index node : coupled.water().pore_nodes.nodes(rock.mesh)) {
    of_nodes += coupled.water().state.growth[at(node)];
  }
  EXPECT_NEAR(of_nodes / growth, 1.0, 1e-12);
}

}  // namespace
}  // namespace percolith::coupling
