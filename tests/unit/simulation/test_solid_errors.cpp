// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "unit/support/solid_setup.hpp"

namespace percolith::simulation {
namespace {

TEST(SolidErrors, AnUnstableStepIsRefusedWithTheLimit) {
  simulation::Setup setup = test::solid_setup();
  setup.time.step = 1.0;
  test::expect_refused(setup, "time.step", "unstable: longer than the stable step of");
  test::expect_refused(setup, "time.step", "or leave it out");
}

TEST(SolidErrors, UnknownGroupsAreNamed) {
  simulation::Setup setup = test::solid_setup();
  setup.boundary["side"] = test::on("lefft");
  setup.boundary["side"].fixed = true;
  test::expect_refused(setup, "boundary.side.groups[0]", "lefft");
  setup = test::solid_setup();
  setup.body["block"].regions = {"rok"};
  test::expect_refused(setup, "body.block.regions[0]", "rok");
  setup = test::solid_setup();
  setup.excavation["hole"].regions = {"rok"};
  test::expect_refused(setup, "excavation.hole.regions[0]", "rok");
  setup = test::solid_setup();
  setup.fracture["crack"].groups = {"levl"};
  test::expect_refused(setup, "fracture.crack.groups[0]", "levl");
}

TEST(SolidErrors, AnEdgeBelongsToOneFracture) {
  simulation::Setup setup = test::solid_setup();
  setup.fracture["a"].groups = {"level"};
  setup.fracture["b"].groups = {"level"};
  test::expect_refused(setup, "fracture.b.groups", "already belongs to another fracture");
}

TEST(SolidErrors, BodiesThatOverlapAtTheStartAreRefused) {
  simulation::Setup setup = test::solid_setup();
  mesh::GmshMesh file = test::plain_mesh();
  file.regions.push_back("block");
  setup.material["sandstone"].regions = {"rock", "block"};
  const auto first = static_cast<std::int32_t>(file.points.size());
  const auto place = [&](double x) {
    mesh::GmshMesh both = file;
    for (const Point p : {Point{x, 0.4}, Point{x + 0.5, 0.4}, Point{x, 0.6}}) {
      both.points.push_back(p);
    }
    both.triangles.push_back({first, first + 1, first + 2});
    both.triangle_region.push_back(1);
    return both;
  };
  EXPECT_NO_THROW(Simulation(setup, place(1.0)));
  test::expect_input_error([&] { Simulation(setup, place(0.9)); }, "mesh.file",
                           "bodies overlap at the start");
}

TEST(SolidErrors, APointForceOffTheRockIsRefused) {
  simulation::Setup setup = test::solid_setup();
  setup.point_force["load"].point = {3.0, 0.5};
  setup.point_force["load"].force_y = Schedule::constant(-1.0);
  test::expect_refused(setup, "point_force.load.point", "no vertex of the mesh is near");
  setup.point_force["load"].point = {1.0, 0.5};
  EXPECT_NO_THROW(Simulation(setup, test::plain_mesh()));
}

TEST(SolidErrors, AProbeOutsideTheRockIsRefused) {
  simulation::Setup setup = test::solid_setup();
  setup.probe["far"].point = std::array<double, 2>{5.0, 5.0};
  EXPECT_THROW(Simulation(setup, test::plain_mesh()), InputError);
}

TEST(SolidErrors, OverConstrainedPointsAreRefused) {
  simulation::Setup setup = test::solid_setup();
  setup.boundary["a"] = test::on("left");
  setup.boundary["a"].fixed = true;
  setup.boundary["b"] = test::on("bottom");
  setup.boundary["b"].velocity_x = Schedule::constant(1.0);
  try {
    Simulation(setup, test::plain_mesh());
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("the point at (0, 0) is over-constrained"),
              std::string::npos)
        << error.what();
  }
}

TEST(SolidErrors, ACaseInWhichNothingMovesIsWarnedOf) {
  const CheckReport report = Simulation(test::solid_setup(), test::plain_mesh()).check();
  ASSERT_FALSE(report.warnings.empty());
  EXPECT_NE(report.warnings.back().find("nothing will move"), std::string::npos);
}

bool warns(const CheckReport& report, const std::string& text) {
  return std::any_of(report.warnings.begin(), report.warnings.end(),
                     [&](const std::string& w) { return w.find(text) != std::string::npos; });
}

TEST(SolidErrors, ADisplacementMustBeginWithZero) {
  simulation::Setup setup = test::solid_setup();
  setup.boundary["top"] = test::on("top");
  setup.boundary["top"].displacement_y = Schedule::constant(-1e-3);
  test::expect_refused(setup, "boundary.top.displacement_y", "is -0.001 m at time 0");
  setup.boundary["top"].displacement_y = Schedule{{0.0, 1.0}, {0.0, -1e-3}};
  EXPECT_NO_THROW(Simulation(setup, test::plain_mesh()));
}

TEST(SolidErrors, CurvesWithoutAFractureAreWarnedOf) {
  simulation::Setup setup = test::solid_setup();
  const std::string text = "the physical curve \"level\" lies inside the rock";
  EXPECT_TRUE(warns(Simulation(setup, test::plain_mesh()).check(), text));
  setup.fracture["crack"].groups = {"level"};
  EXPECT_FALSE(warns(Simulation(setup, test::plain_mesh()).check(), text));
}

/// Rows of equilateral triangles, or the same with their inner points moved.
mesh::GmshMesh lattice(double jitter) {
  test::Grid grid{.columns = 16, .rows = 16, .width = 1.0, .height = 0.8660254, .jitter = jitter};
  mesh::GmshMesh file = test::make_grid(grid);
  for (Point& p : file.points) {
    p.x -= p.y / std::sqrt(3.0);
  }
  return file;
}

TEST(SolidErrors, RegularMeshesAreWarnedOf) {
  const simulation::Setup setup = test::solid_setup();
  const std::string text = "run in few directions";
  EXPECT_TRUE(warns(Simulation(setup, lattice(0.0)).check(), text));
  EXPECT_FALSE(warns(Simulation(setup, lattice(0.4)).check(), text));
}

TEST(SolidErrors, RunsThatWouldTakeYearsAreToldOf) {
  simulation::Setup setup = test::solid_setup();
  const std::string text = "steps of";
  EXPECT_FALSE(warns(Simulation(setup, test::plain_mesh()).check(), text));
  setup.time.end = 2592000.0;
  const CheckReport report = Simulation(setup, test::plain_mesh()).check();
  EXPECT_TRUE(warns(report, "time.end = 2.592e+06 s takes "));
  EXPECT_TRUE(warns(report, "years of computing. Motion is for what lasts as long as waves in the "
                            "rock take; for slow injection take time.scheme = \"quasi_static\""));
}

TEST(SolidErrors, StepsThatAreFarTooShortAreToldOf) {
  simulation::Setup setup = test::solid_setup();
  const double stable =
      setup.time.safety * Simulation(setup, test::plain_mesh()).check().limits.back().step;
  const std::string text = "times shorter than the";
  setup.time.step = 0.02 * stable;
  EXPECT_FALSE(warns(Simulation(setup, test::plain_mesh()).check(), text));
  setup.time.step = 0.004 * stable;
  EXPECT_TRUE(warns(Simulation(setup, test::plain_mesh()).check(), "is 250 times shorter"));
}

/// Where only the joints of a straight fracture may break, they say nothing of the mesh.
TEST(SolidErrors, AFractureIsNoLattice) {
  const test::Grid grid{.columns = 320, .rows = 2, .width = 32.0, .height = 0.2};
  mesh::GmshMesh file = test::make_grid(grid);
  test::add_row_curve(grid, file, "line", 1, 0, grid.columns);
  simulation::Setup setup = test::solid_setup();
  setup.material["sandstone"].joints = RockJoints::elastic;
  FractureGroup& line = setup.fracture["line"];
  line.groups = {"line"};
  line.bond = Bond::cohesive;
  line.strength = setup.material["sandstone"].strength;
  EXPECT_FALSE(warns(Simulation(setup, file).check(), "run in few directions"));
  setup.material["sandstone"].joints = RockJoints::breakable;
  EXPECT_TRUE(warns(Simulation(setup, file).check(), "run in few directions"));
}

TEST(SolidErrors, AbsorbingBoundariesLimitTheStep) {
  simulation::Setup setup = test::solid_setup();
  setup.material["sandstone"].joints = RockJoints::elastic;
  setup.contact.penalty = 1.0;
  const double free = Simulation(setup, test::plain_mesh()).check().limits.back().step;
  for (const char* side : {"left", "right", "top", "bottom"}) {
    setup.boundary[side] = test::on(side);
    setup.boundary[side].absorbing = true;
  }
  const CheckReport report = Simulation(setup, test::plain_mesh()).check();
  EXPECT_LT(report.limits.back().step, 0.9 * free);
  EXPECT_TRUE(std::any_of(report.limits.begin(), report.limits.end(), [](const StepLimit& limit) {
    return limit.mechanism == "absorbing boundary";
  }));
}

TEST(SolidErrors, CoarseElementsAreWarnedOf) {
  simulation::Setup setup = test::solid_setup();
  setup.material["sandstone"].strength.mode_1_energy = 1.0;
  const CheckReport report = Simulation(setup, test::plain_mesh()).check();
  EXPECT_NE(report.warnings.front().find("do not resolve the cohesive length"), std::string::npos);
  // E'/f_t^2 for 1 J/m2 over the mean size of the elements.
  const double size = 2 * std::sqrt(1.0 / 128 / std::sqrt(3.0));
  EXPECT_NEAR(test::value_of(report.mechanics, "smallest cohesive length over element size"),
              10e9 / (1 - 0.0625) / 25e12 / size, 1e-6);
}

}  // namespace
}  // namespace percolith::simulation
