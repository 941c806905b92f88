// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "unit/support/solid_setup.hpp"

namespace percolith::simulation {
namespace {

using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;

const test::Grid block{.columns = 4, .rows = 4, .width = 20.0, .height = 10.0};

/// A block under stress, which `held` sides carry on.
simulation::Setup pressed(const std::vector<std::string>& held) {
  simulation::Setup setup = test::solid_setup();
  setup.in_situ = InSitu{.stress_xx = -8e6, .stress_yy = -12e6};
  for (const std::string& side : held) {
    setup.boundary[side] = test::on(side);
    setup.boundary[side].in_situ = true;
  }
  return setup;
}

std::vector<std::string> warnings_of(const Setup& setup) {
  return Simulation(setup, test::make_grid(block)).check().warnings;
}

TEST(StartBalance, EdgesThatDoNotHoldTheInSituStressAreToldOf) {
  EXPECT_THAT(warnings_of(pressed({"left", "right"})),
              Contains(HasSubstr("in-situ stress ends at 40 m of edges that do not hold it "
                                 "(\"bottom\", \"top\"): up to 12 MPa, at (2.5, 0). The rock "
                                 "springs out there when the run starts.")));
  EXPECT_THAT(warnings_of(pressed({"left", "right", "top"})),
              Contains(HasSubstr("ends at 20 m of edges that do not hold it (\"bottom\")")));
  EXPECT_THAT(warnings_of(pressed({"left", "right", "top", "bottom"})),
              Each(Not(HasSubstr("in-situ"))));
}

/// Coupled physics is one of two in which a boundary has a pressure; only there it can press.
TEST(StartBalance, APressureThatTheFluidAloneFeelsHoldsNothing) {
  simulation::Setup setup = pressed({"left", "right", "top"});
  setup.model.physics = Physics::coupled;
  setup.time.scheme = Scheme::explicit_;
  setup.material["sandstone"].rock.permeability = {1e-15, 1e-15, 0.0};
  setup.material["sandstone"].rock.porosity = 0.1;
  setup.new_cracks = NewCracks{};
  setup.boundary["bottom"] = test::on("bottom");
  setup.boundary["bottom"].pressure = Schedule::constant(12e6);
  EXPECT_THAT(
      warnings_of(setup),
      Contains(HasSubstr("What boundary.bottom says of pressure the fluid alone feels: with "
                         "pressurised = true it presses on the rock as well.")));
  setup.boundary["bottom"].pressurised = true;
  EXPECT_THAT(warnings_of(setup), Each(Not(HasSubstr("in-situ"))));
}

TEST(StartBalance, LoadsHoldAndAbsorbingEdgesGiveWay) {
  simulation::Setup setup = pressed({"left", "right", "top"});
  setup.boundary["bottom"] = test::on("bottom");
  setup.boundary["bottom"].absorbing = true;
  EXPECT_THAT(warnings_of(setup), Contains(HasSubstr("ends at 20 m")));
  setup.boundary["bottom"].absorbing = false;
  setup.boundary["bottom"].traction_y = Schedule::constant(0.0);
  EXPECT_THAT(warnings_of(setup), Contains(HasSubstr("ends at 20 m")));
  setup.boundary["bottom"].traction_y = Schedule::constant(12e6);
  EXPECT_THAT(warnings_of(setup), Each(Not(HasSubstr("in-situ"))));
}

TEST(StartBalance, FreeGroundBearsNoStressThatVanishesThere) {
  simulation::Setup setup = pressed({"left", "right", "bottom"});
  setup.model.gravity = 10.0;
  setup.in_situ = InSitu{.gradient_xx = 1e4, .gradient_yy = 25e3, .datum = 10.0};
  EXPECT_THAT(warnings_of(setup), Each(Not(HasSubstr("in-situ"))));
}

TEST(StartBalance, RockThatIsTakenOutNeedsNoHold) {
  simulation::Setup setup = pressed({"left", "right", "top"});
  setup.excavation["all"].regions = {"rock"};
  EXPECT_THAT(warnings_of(setup), Each(Not(HasSubstr("ends at"))));
  setup.excavation["all"].start = 1e-4;
  EXPECT_THAT(warnings_of(setup), Contains(HasSubstr("ends at 20 m")));
}

TEST(StartBalance, WeightThatTheStressDoesNotCarryIsToldOf) {
  simulation::Setup setup = pressed({"left", "right", "top", "bottom"});
  setup.model.gravity = 10.0;  // 250 kPa over the height against 12 MPa: little
  EXPECT_THAT(warnings_of(setup), Each(Not(HasSubstr("weight"))));
  setup.in_situ->stress_yy = -2e6;
  setup.in_situ->stress_xx = -1e6;
  EXPECT_THAT(warnings_of(setup),
              Contains("the in-situ stress does not carry the weight of the rock: over the 10 m of "
                       "its height gravity adds 250 kPa and in_situ.gradient_yy 0 Pa. The rock "
                       "settles when the run starts. gradient_yy = 25000 (Pa/m) carries it; "
                       "model.gravity = 0 leaves weight out"));
  setup.in_situ->gradient_yy = 22e3;
  EXPECT_THAT(warnings_of(setup), Each(Not(HasSubstr("weight"))));
  setup.in_situ->gradient_yy = -25e3;
  EXPECT_THAT(warnings_of(setup), Contains(HasSubstr("weight")));
  setup.model.gravity = 0.0;
  setup.in_situ->gradient_yy = 25e3;
  EXPECT_THAT(warnings_of(setup), Contains(HasSubstr("gravity adds 0 Pa and in_situ.gradient_yy "
                                                     "250 kPa. The rock settles when the run "
                                                     "starts. gradient_yy = 0 (Pa/m) carries it")));
}

/// The upper half of the block is denser, or a platen.
TEST(StartBalance, WeightIsThatOfTheRockThatIsThere) {
  mesh::GmshMesh mesh = test::make_grid(block);
  mesh.regions.push_back("upper");
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    mesh.triangle_region[t] = t >= mesh.triangles.size() / 2 ? 1 : 0;
  }
  simulation::Setup setup = pressed({"left", "right", "top", "bottom"});
  setup.model.gravity = 10.0;
  setup.in_situ->stress_xx = -1e6;
  setup.in_situ->stress_yy = -1e6;
  setup.material["steel"] = setup.material["sandstone"];
  setup.material["steel"].regions = {"upper"};
  setup.material["steel"].solid.density = 7500.0;
  const auto warnings = [&] { return Simulation(setup, mesh).check().warnings; };
  for (const double gradient : {25e3, 50e3, 75e3}) {
    setup.in_situ->gradient_yy = gradient;
    EXPECT_THAT(warnings(), Each(Not(HasSubstr("weight")))) << gradient;
  }
  setup.in_situ->gradient_yy = 0.0;
  EXPECT_THAT(warnings(), Contains(HasSubstr("gradient_yy = 50000 (Pa/m) carries it on average")));
  setup.boundary.erase("top");
  setup.body["platen"].regions = {"upper"};
  setup.body["platen"].rigid = true;
  EXPECT_THAT(warnings(), Contains(HasSubstr("gradient_yy = 25000 (Pa/m) carries it;")));
}

}  // namespace
}  // namespace percolith::simulation
