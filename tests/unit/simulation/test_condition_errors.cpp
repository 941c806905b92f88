// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "unit/support/setup.hpp"

namespace percolith::simulation {
namespace {

using test::expect_refused;
using test::plain_setup;

constexpr double infinity = std::numeric_limits<double>::infinity();

BoundaryCondition boundary(const std::string& group) {
  BoundaryCondition condition;
  condition.groups = {group};
  return condition;
}

TEST(ConditionErrors, AnEdgeHasOneCondition) {
  simulation::Setup setup = plain_setup();
  setup.boundary["leak"] = boundary("left");
  setup.boundary["leak"].flux = Schedule::constant(1e-9);
  expect_refused(setup, "boundary.leak.groups", "its edge at (0, ");
  expect_refused(setup, "boundary.leak.groups",
                 ") already has the condition boundary.inlet; allowed: each boundary edge in one "
                 "boundary table");
}

TEST(ConditionErrors, TwoPressuresAtOnePlaceContradict) {
  simulation::Setup setup = plain_setup();
  setup.boundary["roof"] = boundary("top");
  setup.boundary["roof"].pressure = Schedule::constant(5e4);
  setup.boundary.erase("inlet");
  expect_refused(setup, "boundary.roof.pressure",
                 "prescribes 50000 Pa at (1, 1), where boundary.outlet.pressure prescribes 0 Pa "
                 "(at time 0 s); allowed: one pressure per place; end one of the groups an edge "
                 "earlier, or give both the same value there");
}

TEST(ConditionErrors, TwoPressuresThatPartLaterContradictToo) {
  simulation::Setup setup = plain_setup();
  setup.time.scheme = Scheme::implicit;
  setup.time.end = 10.0;
  setup.boundary.erase("outlet");
  setup.boundary["roof"] = boundary("top");
  setup.boundary["roof"].pressure = Schedule{{0.0, 4.0}, {1e5, 2e5}, Interpolation::step};
  expect_refused(setup, "boundary.roof.pressure",
                 "prescribes 200000 Pa at (0, 1), where boundary.inlet.pressure prescribes 100000 "
                 "Pa (at time 4 s)");
  // The same table twice agrees.
  setup.boundary["inlet"].pressure = setup.boundary["roof"].pressure;
  EXPECT_NO_THROW(Simulation(setup, test::plain_mesh()));
}

TEST(ConditionErrors, HeadAndPressureOfEqualMeaningAgree) {
  simulation::Setup setup = plain_setup();
  setup.model.gravity = 9.81;
  setup.model.head_datum = -3.0;
  setup.boundary.clear();
  setup.boundary["roof"] = boundary("top");
  setup.boundary["roof"].pressure = Schedule::constant(1000.0 * 9.81 * 6.0);
  setup.boundary["side"] = boundary("left");
  setup.boundary["side"].head = Schedule::constant(10.0);  // 6 m above (0, 1), which is at 4 m
  EXPECT_NO_THROW(Simulation(setup, test::plain_mesh()));
  setup.boundary["side"].head = Schedule::constant(10.001);
  expect_refused(setup, "boundary.side.head",
                 "prescribes 58869.8 Pa at (0, 1), where boundary.roof.pressure prescribes 58860 "
                 "Pa");
}

TEST(ConditionErrors, PressuresBelowCavitationAreRefusedUnlessTheRockStaysSaturated) {
  simulation::Setup setup = plain_setup();
  setup.boundary["outlet"].pressure = Schedule{{0.0, 1.0}, {0.0, -2e4}, Interpolation::linear};
  expect_refused(setup, "boundary.outlet.pressure",
                 "prescribes -20000 Pa at (1, 1), below the cavitation pressure of 0 Pa; allowed: "
                 "pressures not below fluid.cavitation_pressure, a seepage_face, or "
                 "fluid.cavitation_pressure = \"-inf\"");
  setup.fluid.cavitation_pressure = -infinity;
  EXPECT_NO_THROW(Simulation(setup, test::plain_mesh()));
  setup = plain_setup();
  setup.boundary.erase("outlet");
  setup.boundary["face"] = boundary("right");
  setup.boundary["face"].seepage_face = Schedule::constant(-1.0);
  expect_refused(setup, "boundary.face.seepage_face", "prescribes -1 Pa at (1, ");
}

TEST(ConditionErrors, AHeadBelowTheTopOfItsBoundaryIsToldHowToBeSplit) {
  simulation::Setup setup = plain_setup();
  setup.model.gravity = 9.81;
  setup.boundary.clear();
  setup.boundary["lake"] = boundary("left");
  setup.boundary["lake"].head = Schedule::constant(0.5);
  expect_refused(setup, "boundary.lake.head",
                 "below the cavitation pressure of 0 Pa; allowed: a head not below the top of the "
                 "boundary: split it in the mesh into a wet part, which keeps the head, and the "
                 "part above, without a condition or with seepage_face = 0 where water may come "
                 "out; or fluid.cavitation_pressure = \"-inf\"");
  setup.boundary["lake"].head = Schedule::constant(1.0);
  EXPECT_NO_THROW(Simulation(setup, test::plain_mesh()));
}

TEST(ConditionErrors, TwoSeepageFacesOfDifferentOutsidePressureContradict) {
  simulation::Setup setup = plain_setup();
  setup.boundary.erase("outlet");
  setup.boundary["face"] = boundary("right");
  setup.boundary["face"].seepage_face = Schedule::constant(0.0);
  setup.boundary["roof"] = boundary("top");
  setup.boundary["roof"].seepage_face = Schedule::constant(1e3);
  expect_refused(setup, "boundary.roof.seepage_face",
                 "prescribes 1000 Pa at (1, 1), where boundary.face.seepage_face prescribes 0 Pa");
  setup.boundary["roof"].seepage_face = Schedule::constant(0.0);
  EXPECT_NO_THROW(Simulation(setup, test::plain_mesh()));
}

TEST(ConditionErrors, CrackAndFacesThatShareOnePressureCannotBeGivenTwo) {
  simulation::Setup setup = plain_setup();
  setup.boundary["roof"] = boundary("top");
  setup.boundary.erase("inlet");
  setup.boundary.erase("outlet");
  setup.boundary["roof"].pressure = Schedule::constant(1e4);
  setup.boundary["roof"].on = Domain::matrix;
  setup.fracture["fault"] = test::fracture_group("upright", 1e-4, 1e-9);
  setup.source["well"].fractures = {"fault"};
  setup.source["well"].pressure = Schedule::constant(2e4);
  // With a resistance between them they differ; without it they contradict.
  EXPECT_NO_THROW(Simulation(setup, test::plain_mesh()));
  setup.fracture["fault"].fracture.exchange = infinity;
  expect_refused(setup, "source.well.pressure",
                 "prescribes 20000 Pa at (0.5, 1), where boundary.roof.pressure prescribes 10000 "
                 "Pa (at time 0 s); allowed: one pressure per place; end one of the groups an edge "
                 "earlier, or give both the same value there");
}

TEST(ConditionErrors, ABoundaryAndASourceMayPartMatrixAndCrack) {
  simulation::Setup setup = plain_setup();
  setup.boundary["roof"] = boundary("top");
  setup.boundary.erase("inlet");
  setup.boundary.erase("outlet");
  setup.boundary["roof"].pressure = Schedule::constant(1e4);
  setup.fracture["fault"] = test::fracture_group("upright", 1e-4, 1e-9);
  setup.source["well"].fractures = {"fault"};
  setup.source["well"].pressure = Schedule::constant(2e4);
  expect_refused(setup, "source.well.pressure",
                 "prescribes 20000 Pa at (0.5, 1), where boundary.roof.pressure prescribes 10000 "
                 "Pa (at time 0 s); allowed: one pressure per place; end one of the groups an edge "
                 "earlier, give both the same value there, or limit a boundary table with on = "
                 "\"matrix\" or \"crack\"");
  setup.boundary["roof"].on = Domain::matrix;
  EXPECT_NO_THROW(Simulation(setup, test::plain_mesh()));
}

TEST(ConditionErrors, ASteadyRunNeedsAPressureSomewhere) {
  simulation::Setup setup = plain_setup();
  setup.boundary.clear();
  setup.boundary["inlet"] = boundary("left");
  setup.boundary["inlet"].flux = Schedule::constant(1e-9);
  expect_refused(setup, "time.scheme",
                 "error: time.scheme = \"steady\": nothing fixes the pressure in the part of the "
                 "model that holds the pore node at (");
  expect_refused(setup, "time.scheme",
                 "allowed: a pressure, head or seepage_face on a boundary or fracture connected to "
                 "it, or a transient scheme");
  setup.time.scheme = Scheme::implicit;
  setup.time.end = 1.0;
  EXPECT_NO_THROW(Simulation(setup, test::plain_mesh()));
}

TEST(SourceErrors, APointLiesWhereItsFluidGoes) {
  simulation::Setup setup = plain_setup();
  setup.source["well"].point = {1.5, 0.5};
  setup.source["well"].rate = Schedule::constant(1e-9);
  expect_refused(setup, "source.well.point",
                 "[1.5, 0.5]: the point lies outside of the rock; allowed: points inside the mesh");
  setup.source["well"].into = Domain::crack;
  expect_refused(setup, "source.well.point",
                 "[1.5, 0.5]: the model has no open crack; allowed: a fracture table, or into = "
                 "\"matrix\"");
  setup.fracture["fault"] = test::fracture_group("level", 1e-4);
  setup.source["well"].point = {0.3, 0.6};
  expect_refused(setup, "source.well.point",
                 "[0.3, 0.6]: the point does not lie on an open crack; allowed: a point on a "
                 "fracture; the nearest is (0.3, 0.5)");
}

TEST(SourceErrors, APressureAtAPointOfTheMatrixHasNoMeaning) {
  simulation::Setup setup = plain_setup();
  setup.source["well"].point = {0.5, 0.5};
  setup.source["well"].pressure = Schedule::constant(1e5);
  expect_refused(setup, "source.well.pressure",
                 "a pressure at a single point of the matrix has no meaning: the flow it drives "
                 "depends on the mesh; allowed: a rate, or a point in a crack, or a boundary round "
                 "a hole");
}

TEST(SourceErrors, FracturesAreNamedByTheirTables) {
  simulation::Setup setup = plain_setup();
  setup.fracture["fault"] = test::fracture_group("level", 1e-4);
  setup.source["well"].fractures = {"fault", "level"};
  setup.source["well"].rate = Schedule::constant(1e-9);
  expect_refused(setup, "source.well.fractures[1]",
                 "\"level\": there is no fracture table of this name; allowed: \"fault\"");
}

TEST(InitialErrors, PressuresBelowCavitationAreRefusedWithTheirPlace) {
  simulation::Setup setup = plain_setup();
  setup.initial.pressure = -1e3;
  expect_refused(setup, "initial.pressure", "gives -1000 Pa at (");
  expect_refused(setup, "initial.pressure",
                 "below the cavitation pressure of 0 Pa; allowed: pressures not below "
                 "fluid.cavitation_pressure, or initial.water_table");
  setup.initial.pressure.reset();
  setup.model.gravity = 9.81;
  setup.initial.head = 0.5;
  expect_refused(setup, "initial.head", "below the cavitation pressure");
  setup.initial.head.reset();
  setup.initial.water_table = 0.5;
  EXPECT_NO_THROW(Simulation(setup, test::plain_mesh()));
  setup.initial.water_table.reset();
  setup.fracture["fault"] = test::fracture_group("level", 1e-4);
  setup.initial.crack_pressure = -5.0;
  expect_refused(setup, "initial.crack_pressure", "gives -5 Pa at (0.5, 0.5)");
}

TEST(InitialErrors, PartlyEmptyRockHasTheCavitationPressure) {
  simulation::Setup setup = plain_setup();
  setup.initial.pressure = 1e5;
  setup.initial.saturation = 0.5;
  expect_refused(setup, "initial.saturation",
                 "initial.saturation = 0.5: partly empty rock stays at the cavitation pressure of "
                 "0 Pa, but the initial pressure is 100000 Pa; allowed: saturation 1, or an "
                 "initial pressure equal to fluid.cavitation_pressure");
  setup.initial.saturation = 1.0;
  setup.initial.crack_saturation = 0.25;
  setup.fracture["fault"] = test::fracture_group("level", 1e-4);
  expect_refused(setup, "initial.crack_saturation", "initial.crack_saturation = 0.25: partly");
}

TEST(ProbeErrors, ProbesLieInTheRockOrOnAFracture) {
  simulation::Setup setup = plain_setup();
  setup.probe["gauge"].point = {2.0, 2.0};
  expect_refused(setup, "probe.gauge.point",
                 "the point lies outside of the rock; allowed: places inside the mesh");
  setup.probe["gauge"].point.reset();
  setup.probe["gauge"].from = {2.0, 2.0};
  setup.probe["gauge"].to = {3.0, 2.0};
  expect_refused(setup, "probe.gauge.from", "the line lies outside of the rock");
  setup.probe["gauge"].in = Domain::crack;
  expect_refused(
      setup, "probe.gauge.from",
      "no joint is near that is open or may open; allowed: places within half an edge of "
      "a fracture or, in rock that breaks, of any joint");
}

}  // namespace
}  // namespace percolith::simulation
