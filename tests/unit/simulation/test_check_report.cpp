// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "unit/support/solid_setup.hpp"

namespace percolith::simulation {
namespace {

TEST(CheckReport, CountsAndMeasuresTheModel) {
  simulation::Setup setup = test::plain_setup();
  setup.fracture["upright"] = test::fracture_group("upright", 1e-4, 1e-9);
  setup.fracture["level"] = test::fracture_group("level", 1e-4, 1e-9);
  const Simulation simulation(setup, test::plain_mesh());
  const CheckReport report = simulation.check();
  EXPECT_EQ(report.triangles, 128);
  EXPECT_EQ(report.vertices, 81);
  EXPECT_EQ(report.boundary_edges, 32);
  EXPECT_EQ(report.joints, (3 * 128 - 32) / 2);
  EXPECT_EQ(report.broken_joints, 12);
  // Seven open nodes each, the crossing shared; the crossing has four pore nodes, the five other
  // inner ones on `level`'s seven and `upright`'s inner four plus its mouth have two.
  EXPECT_EQ(report.crack_nodes, 13);
  EXPECT_EQ(report.pore_nodes, 81 + 3 + 4 + 5);
  EXPECT_EQ(report.unknowns, report.pore_nodes + report.crack_nodes - 18);
  EXPECT_NEAR(report.area, 1.0, 1e-13);
  EXPECT_EQ(report.lower_corner.x, 0.0);
  EXPECT_EQ(report.lower_corner.y, 0.0);
  EXPECT_EQ(report.upper_corner.x, 1.0);
  EXPECT_EQ(report.upper_corner.y, 1.0);
  EXPECT_NEAR(report.region_area.at("rock"), 1.0, 1e-13);
  EXPECT_NEAR(report.smallest_edge, 0.125, 1e-14);
  EXPECT_NEAR(report.largest_edge, 0.125 * std::sqrt(2.0), 1e-14);
  EXPECT_NEAR(report.smallest_angle, 45.0, 1e-10);
  EXPECT_NEAR(report.largest_angle, 90.0, 1e-10);
  EXPECT_NEAR(report.fracture_length, 1.5, 1e-13);
  EXPECT_NEAR(report.fracture_length_by_group.at("upright"), 0.75, 1e-13);
  EXPECT_NEAR(report.fracture_length_by_group.at("level"), 0.75, 1e-13);
  EXPECT_TRUE(report.warnings.empty());
  ASSERT_GE(report.limits.size(), 3u);
  EXPECT_EQ(report.limits.front().mechanism, "crack flow");
  EXPECT_NEAR(report.limits.front().step, 6e-3 * 0.125 * 0.125 / (2.2e9 * 1e-8), 1e-15);
  EXPECT_EQ(simulation.region_names(), (std::vector<std::string>{"rock"}));
  EXPECT_EQ(simulation.fracture_names(), (std::vector<std::string>{"level", "upright"}));
}

TEST(CheckReport, WarnsOfSlenderTriangles) {
  const auto mesh = test::plain_mesh({.columns = 8, .rows = 8, .width = 10.0});
  const CheckReport report = Simulation(test::plain_setup(), mesh).check();
  EXPECT_NEAR(report.smallest_angle, std::atan(0.1) * 180.0 / 3.14159265358979, 1e-9);
  ASSERT_EQ(report.warnings.size(), 1u);
  EXPECT_EQ(report.warnings[0].rfind("the smallest angle of the mesh is 5.7 degree, at (", 0), 0u)
      << report.warnings[0];
}

TEST(CheckReport, NamesImplicitPoresWhereExplicitOnesTakeVeryManySteps) {
  simulation::Setup setup = test::solid_setup();
  setup.model.physics = Physics::coupled;
  setup.time.scheme = Scheme::explicit_;
  Material& rock = setup.material["sandstone"];
  rock.joints = RockJoints::elastic;
  rock.rock.permeability = {1e-7, 1e-7, 0.0};
  rock.rock.porosity = 0.2;
  const std::string steps = "explicit steps of the pores per step of the motion";
  const auto mentions = [](const std::string& option) {
    return testing::Contains(testing::HasSubstr(option));
  };
  const CheckReport many = Simulation(setup, test::plain_mesh()).check();
  EXPECT_GT(test::value_of(many.mechanics, steps), 100.0);
  EXPECT_THAT(many.warnings, mentions("time.pore_flow = \"implicit\""));
  EXPECT_EQ(many.unknowns, 0);

  setup.time.pore_flow = PoreFlow::implicit;
  const CheckReport one = Simulation(setup, test::plain_mesh()).check();
  EXPECT_THAT(one.warnings, testing::Not(mentions("time.pore_flow")));
  EXPECT_EQ(one.unknowns, one.pore_nodes);
  for (const auto& [name, value] : one.mechanics) {
    EXPECT_NE(name, steps);
  }
}

/// The implicit flow of a quasi-static run has no steps of its own, and solves for all nodes.
TEST(CheckReport, OfSlowInjectionTellsOfNoExplicitFlow) {
  simulation::Setup setup = test::solid_setup();
  setup.model.physics = Physics::coupled;
  setup.fracture["level"] = test::fracture_group("level", 1e-4, 1e-9);
  setup.new_cracks = NewCracks{};
  const std::string name = "explicit steps of the pores per step of the motion";
  const auto tells = [&](const CheckReport& report) {
    return std::any_of(report.mechanics.begin(), report.mechanics.end(),
                       [&](const auto& value) { return value.first == name; });
  };
  setup.time.scheme = Scheme::explicit_;
  EXPECT_TRUE(tells(Simulation(setup, test::plain_mesh()).check()));
  setup.time.scheme = Scheme::quasi_static;
  const CheckReport report = Simulation(setup, test::plain_mesh()).check();
  EXPECT_FALSE(tells(report));
  EXPECT_EQ(report.unknowns, report.pore_nodes + report.crack_nodes);
}

}  // namespace
}  // namespace percolith::simulation
