// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/mesh.hpp"
#include "percolith/simulation/crack_starts.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "unit/support/solid_setup.hpp"

namespace percolith::simulation {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// A grid of which the right half has elements that are four times as long.
mesh::GmshMesh graded() {
  const test::Grid grid{.columns = 8, .rows = 4, .width = 8.0, .height = 4.0};
  mesh::GmshMesh file = test::make_grid(grid);
  test::add_row_curve(grid, file, "notch", 2, 0, 2);
  for (Point& p : file.points) {
    p.x = p.x > 4.0 ? 4.0 + 4.0 * (p.x - 4.0) : p.x;
  }
  return file;
}

/// Rock whose cohesive length is `length` (m), pulled at its right side.
Setup rock_of(double length) {
  simulation::Setup setup = test::solid_setup();
  Material& rock = setup.material["sandstone"];
  const double modulus = 10e9 / (1.0 - 0.0625);
  rock.strength.mode_1_energy = length * 25e12 / modulus;
  setup.boundary["pull"] = test::on("right");
  setup.boundary["pull"].traction_x = Schedule::constant(1e5);
  return setup;
}

/// h of the triangles on the left: the edge of the equilateral one with half a square metre.
const double fine = 2.0 * std::sqrt(0.5 / std::sqrt(3.0));

std::vector<std::string> warnings_of(const Setup& setup, const mesh::GmshMesh& mesh) {
  return Simulation(setup, mesh).check().warnings;
}

TEST(CheckWarnings, CohesiveLengthIsJudgedWhereCracksStart) {
  simulation::Setup setup = rock_of(3.2 * fine);
  EXPECT_THAT(warnings_of(setup, graded()),
              Contains(HasSubstr("of them fit into it, where three should")));
  setup.fracture["notch"].groups = {"notch"};
  const CheckReport report = Simulation(setup, graded()).check();
  EXPECT_THAT(report.warnings, Each(Not(HasSubstr("cohesive length"))));
  EXPECT_NEAR(
      test::value_of(report.mechanics, "cohesive length over element size where cracks start"), 3.2,
      1e-9);
  // From the end at (2, 2) to the middle of the first edge between the halves.
  EXPECT_NEAR(test::value_of(report.mechanics, "it is below 3 from this distance on (m)"),
              std::hypot(2.0, 0.5), 1e-9);
  EXPECT_NEAR(test::value_of(report.mechanics, "smallest cohesive length over element size"), 1.6,
              1e-9);
}

TEST(CheckWarnings, ElementsThatAreTooLargeWhereCracksStartAreNamedWithTheNumbers) {
  simulation::Setup setup = rock_of(1.5 * fine);
  setup.fracture["notch"].groups = {"notch"};
  EXPECT_THAT(warnings_of(setup, graded()),
              Contains("elements of 1.07 m where cracks start, at the end of fracture.notch (2, "
                       "2), do not resolve the cohesive length E' G_I/f_t^2 = 1.61 m: 1.5 of them "
                       "fit into it, where three should. Strength rather than fracture energy "
                       "rules there, and results depend on the mesh. Take elements of at most "
                       "0.54 m there, or a larger mode_1_energy"));
}

TEST(CrackStarts, AreEndsOfFracturesSourcesPressedBoundariesAndExcavations) {
  const mesh::Mesh mesh = mesh::build_mesh(graded());
  simulation::Setup setup = rock_of(1.0);
  const auto starts = [&] {
    std::vector<std::string> names;
    for (const CrackStart& start : crack_starts(setup, mesh)) {
      names.push_back(start.what);
    }
    return names;
  };
  EXPECT_TRUE(starts().empty());
  setup.fracture["notch"].groups = {"notch"};
  EXPECT_EQ(starts(), std::vector<std::string>{"the end of fracture.notch"});  // not its mouth
  setup.fracture["notch"].bond = Bond::cohesive;
  EXPECT_EQ(starts(), std::vector<std::string>(3, "fracture.notch"));
  setup.source["well"].point = {{2.9, 2.2}};
  EXPECT_THAT(starts(), Contains("source.well"));
  setup.boundary["wall"] = test::on("left");
  setup.boundary["wall"].pressure = Schedule::constant(1e6);
  EXPECT_THAT(starts(), Each(Not(HasSubstr("boundary"))));
  setup.boundary["wall"].pressurised = true;
  EXPECT_THAT(starts(), AllOf(Contains("boundary.wall"), Not(Contains("fracture.notch"))));
  setup.initial.pressure = 1e6;  // which the boundary keeps
  EXPECT_THAT(starts(), Each(Not(HasSubstr("boundary"))));
}

TEST(CrackStarts, AreTheWallsOfHolesAndOfExcavations) {
  mesh::GmshMesh file = test::make_grid({.columns = 3, .rows = 3});
  file.regions = {"rock", "core"};
  file.triangle_region.assign(file.triangles.size(), 0);
  file.triangle_region[8] = 1;  // the square in the middle
  file.triangle_region[9] = 1;
  simulation::Setup setup = rock_of(1.0);
  setup.excavation["tunnel"].regions = {"core"};
  const auto dug = crack_starts(setup, mesh::build_mesh(file));
  ASSERT_EQ(dug.size(), 4u);
  EXPECT_EQ(dug[0].what, "the wall of excavation.tunnel");
  EXPECT_TRUE(hole_vertices(mesh::build_mesh(file)).empty());
  file.triangles.erase(file.triangles.begin() + 8, file.triangles.begin() + 10);
  file.triangle_region.assign(file.triangles.size(), 0);
  setup.excavation.clear();
  const auto hole = crack_starts(setup, mesh::build_mesh(file));
  ASSERT_EQ(hole.size(), 4u);
  EXPECT_EQ(hole[0].what, "the wall of a hole");
}

/// The block in a stress that is the same everywhere, Pa.
Setup stressed(double xx, double yy) {
  simulation::Setup setup = rock_of(100.0);
  setup.in_situ = InSitu{.stress_xx = xx, .stress_yy = yy};
  return setup;
}

TEST(StartStrength, StressBelowTheStrengthIsNotWarnedOf) {
  EXPECT_THAT(warnings_of(stressed(-20e6, -20e6), graded()), Each(Not(HasSubstr("fail at once"))));
  EXPECT_THAT(warnings_of(stressed(4.9e6, -1e6), graded()), Each(Not(HasSubstr("fail at once"))));
}

TEST(StartStrength, TensionIsToldPerMaterialWithTheNumbers) {
  // Joints upright bear stress_xx: 7 columns of 4.
  EXPECT_THAT(
      warnings_of(stressed(12e6, 0.0), graded()),
      Contains(AllOf(StartsWith("the stress at the start is more than the joints of "
                                "material.sandstone bear: "),
                     HasSubstr("the tension across a joint is 12 MPa, and its tensile_strength 5 "
                               "MPa (effective, tension positive). Look at the signs and units of "
                               "[in_situ], where compression is negative"))));
}

TEST(StartStrength, ShearIsComparedWithCohesionAndFriction) {
  // On the diagonals t_n = -40 MPa and |t_s| = 40 MPa: they bear 15 MPa + 40 MPa tan 0.6.
  const mesh::GmshMesh even = test::make_grid({.columns = 4, .rows = 4});
  EXPECT_THAT(warnings_of(stressed(-80e6, 0.0), even), Each(Not(HasSubstr("at once"))));
  simulation::Setup setup = stressed(-80e6, 0.0);
  setup.material["sandstone"].strength.cohesion = 10e6;
  EXPECT_THAT(warnings_of(setup, even),
              Contains(HasSubstr("the shear stress along a joint is 40 MPa, and its cohesion and "
                                 "friction bear 37.4 MPa under a normal stress of -40 MPa")));
}

TEST(StartStrength, PorePressureCounts) {
  simulation::Setup setup = stressed(-20e6, -20e6);
  setup.model.physics = Physics::coupled;
  material::Fracture& cracks = setup.new_cracks.emplace().fracture;
  cracks.minimum_aperture = 1e-5;
  cracks.exchange = 1e-9;
  setup.time.scheme = Scheme::explicit_;
  setup.material["sandstone"].rock.permeability = {1e-18, 1e-18, 0.0};
  setup.initial.pressure = 30e6;
  EXPECT_THAT(warnings_of(setup, graded()),
              Contains(HasSubstr("the tension across a joint is 10 MPa")));
}

/// A steady pressure in a fracture, and a rock of mu S/k = `1/diffusivity` beside it.
Setup leaking(double diffusivity) {
  simulation::Setup setup = test::plain_setup();
  setup.boundary.clear();
  setup.fracture["level"] = test::fracture_group("level", 1e-3);
  setup.source["pump"].fractures = {"level"};
  setup.source["pump"].pressure = Schedule::constant(1e5);
  setup.time.scheme = Scheme::implicit;
  setup.time.end = 1.0;
  const double k = diffusivity * setup.fluid.viscosity * 0.2 / setup.fluid.bulk_modulus;
  setup.material["sandstone"].rock.permeability = {k, k, 0.0};
  return setup;
}

TEST(LeakOff, IsWarnedOfWhereFluidStaysWithinOneElement) {
  // h = 0.1343 m of triangles of 1/128 m2.
  EXPECT_TRUE(warnings_of(leaking(0.15 * 0.15), test::plain_mesh()).empty());
  EXPECT_THAT(warnings_of(leaking(0.03 * 0.03), test::plain_mesh()),
              Contains(AllOf(StartsWith("by the end of the run fluid gets sqrt(k t/(mu S)) = 0.03 "
                                        "m into the rock beside fracture.level, less than one "
                                        "element (0.13 m at ("),
                             HasSubstr("the size of the elements sets what leaks off, not the "
                                       "permeability, and makes it too much. Where leak-off "
                                       "matters take elements of at most 0.01 m there, or a "
                                       "fracture.level.exchange that makes the wall slower"))));
}

TEST(LeakOff, OfAWallThatIsSlowerThanTheRockIsNotWarnedOf) {
  simulation::Setup setup = leaking(0.03 * 0.03);
  const double k = setup.material["sandstone"].rock.permeability.xx;
  const double rock = k / (setup.fluid.viscosity * 0.03);
  setup.fracture["level"].fracture.exchange = 0.9 * rock;
  EXPECT_TRUE(warnings_of(setup, test::plain_mesh()).empty());
  setup.fracture["level"].fracture.exchange = 1.1 * rock;
  EXPECT_THAT(warnings_of(setup, test::plain_mesh()),
              Contains(HasSubstr("fracture.level.exchange sets what leaks off")));
}

TEST(LeakOff, NeedsSomethingThatMovesFluid) {
  simulation::Setup setup = leaking(0.03 * 0.03);
  setup.initial.pressure = 1e5;
  EXPECT_TRUE(warnings_of(setup, test::plain_mesh()).empty());
  setup.source["pump"].pressure = Schedule{{0.0, 0.5}, {1e5, 2e5}, Interpolation::step};
  EXPECT_THAT(warnings_of(setup, test::plain_mesh()), Contains(HasSubstr("leaks off")));
}

TEST(LeakOff, CountsTheStorageOfRockThatDeforms) {
  simulation::Setup setup = test::solid_setup();
  setup.model.physics = Physics::coupled;
  setup.time.scheme = Scheme::explicit_;
  setup.time.end = 1.0;
  Material& rock = setup.material["sandstone"];
  rock.joints = RockJoints::elastic;
  rock.rock.biot_modulus = 12e9;  // as E (1 - nu)/((1 + nu)(1 - 2 nu)): S = 2/M
  rock.rock.permeability = {1e-15, 1e-15, 0.0};
  setup.source["well"].point = {{0.4, 0.4}};
  setup.source["well"].rate = Schedule::constant(1e-3);
  const double depth = std::sqrt(1e-12 * 0.5 * 12e9);
  setup.time.end = std::pow(0.05 / depth, 2);
  EXPECT_THAT(warnings_of(setup, test::plain_mesh()),
              Contains(AllOf(HasSubstr("gets sqrt(k t/(mu S)) = 0.05 m into the rock at "
                                       "source.well"),
                             HasSubstr("the pressure there follows from the size of the elements. "
                                       "Take elements of at most 0.017 m there"))));
}

/// Steady flow through a block of 1 m from a water level (m).
Setup beside_water(double level) {
  simulation::Setup setup = test::plain_setup();
  setup.model.gravity = 9.81;
  setup.boundary.clear();
  setup.boundary["lake"].groups = {"bottom"};
  setup.boundary["lake"].head = Schedule::constant(level);
  setup.boundary["face"].groups = {"right"};
  setup.boundary["face"].seepage_face = Schedule::constant(0.0);
  return setup;
}

TEST(SteadySuction, OfRockAboveTheWaterIsForeseen) {
  EXPECT_THAT(warnings_of(beside_water(0.4), test::plain_mesh()),
              Contains(AllOf(StartsWith("the rock reaches up to ("),
                             HasSubstr(", 1), and no condition lifts water above y = 0.4 m: the "
                                       "rock would drain there, and the steady run will stop. "
                                       "Use time.scheme = \"implicit\" with time.stop_ratio"))));
  EXPECT_THAT(warnings_of(beside_water(1.0), test::plain_mesh()),
              Each(Not(HasSubstr("would drain"))));
}

TEST(SteadySuction, IsNotForeseenWhereItCannotBeSure) {
  const auto warns = [](const simulation::Setup& setup) {
    return testing::Matches(Contains(HasSubstr("would drain")))(
        warnings_of(setup, test::plain_mesh()));
  };
  EXPECT_TRUE(warns(beside_water(0.4)));
  simulation::Setup setup = beside_water(0.4);
  setup.fluid.cavitation_pressure = -std::numeric_limits<double>::infinity();
  EXPECT_FALSE(warns(setup));
  setup.fluid.cavitation_pressure = -1e5;  // suction holds the water
  EXPECT_FALSE(warns(setup));
  setup = beside_water(0.4);
  setup.source["well"].point = {{0.4, 0.4}};
  setup.source["well"].rate = Schedule::constant(1e-3);
  EXPECT_FALSE(warns(setup));
  setup.source["well"].rate = Schedule::constant(-1e-3);
  EXPECT_TRUE(warns(setup));
  setup = beside_water(0.4);
  setup.time.scheme = Scheme::implicit;
  setup.time.end = 1.0;
  EXPECT_FALSE(warns(setup));
}

/// A fracture that a pump feeds and that reaches a wall with a pressure of its own.
Setup pumped_notch() {
  simulation::Setup setup = leaking(1.0);
  setup.fracture["level"].groups = {"upright"};
  setup.boundary["hole"].groups = {"top"};
  setup.boundary["hole"].normal_pressure = Schedule::constant(2e6);
  return setup;
}

TEST(PumpedMouth, IsWarnedOfWhereTheOpeningKeepsAPressureOfItsOwn) {
  EXPECT_THAT(warnings_of(pumped_notch(), test::plain_mesh()),
              Contains(AllOf(StartsWith("fracture.level, which source.pump pumps into, ends on "
                                        "boundary.hole at (0.5, 1), but the fluid there keeps to "
                                        "boundary.hole.normal_pressure"),
                             HasSubstr("pressurised = true instead of the source"))));
}

TEST(PumpedMouth, IsNotWarnedOfElsewhere) {
  simulation::Setup setup = pumped_notch();
  setup.source["pump"].fractures.clear();
  setup.source["pump"].point = {{0.5, 0.75}};
  setup.source["pump"].into = Domain::crack;
  EXPECT_THAT(warnings_of(setup, test::plain_mesh()), Each(Not(HasSubstr("pumps into"))));
  setup = pumped_notch();
  setup.boundary["hole"].normal_pressure.reset();
  EXPECT_THAT(warnings_of(setup, test::plain_mesh()), Each(Not(HasSubstr("pumps into"))));
}

}  // namespace
}  // namespace percolith::simulation
