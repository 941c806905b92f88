// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/documents.hpp"

#include <gmock/gmock.h>

#include "unit/case/mechanics_case.hpp"
#include "unit/case/minimal_case.hpp"

namespace percolith::case_file {
namespace {

using testing::HasSubstr;

TEST(ReadCoupled, TakesTheOptionsOfBothHalves) {
  const simulation::Setup setup = read(coupled_case).setup;
  EXPECT_EQ(setup.model.physics, simulation::Physics::coupled);
  EXPECT_EQ(setup.time.scheme, simulation::Scheme::explicit_);
  EXPECT_EQ(setup.model.joint_stress, simulation::JointStress::effective);
  EXPECT_EQ(setup.material.at("rock").biot_coefficient, 1.0);
  ASSERT_TRUE(setup.new_cracks);
  EXPECT_DOUBLE_EQ(setup.new_cracks->fracture.initial_aperture, 1e-4);
  EXPECT_TRUE(setup.boundary.at("wall").pressurised);
}

TEST(ReadCoupled, AsksForWhatBothHalvesNeed) {
  EXPECT_THAT(coupled_error({"material.rock.porosity="}), HasSubstr("porosity"));
  EXPECT_THAT(coupled_error({"material.rock.density="}), HasSubstr("density"));
  EXPECT_THAT(coupled_error({"new_cracks="}),
              HasSubstr("new_cracks: required but missing: joints may break"));
  EXPECT_THAT(coupled_error({"new_cracks.exchange="}), HasSubstr("new_cracks.exchange: required"));
}

TEST(ReadCoupled, RefusesWhatItCannotCompute) {
  EXPECT_THAT(coupled_error({"time.scheme=implicit"}), HasSubstr("advanced explicitly"));
  EXPECT_THAT(coupled_error({"model.plane=stress"}), HasSubstr("plane strain"));
  EXPECT_THAT(coupled_error({"fluid.cavitation_pressure=-inf"}), HasSubstr("tear at the faces"));
  EXPECT_THAT(coupled_error({"new_cracks.exchange=inf"}), HasSubstr("one pressure"));
  EXPECT_THAT(coupled_error({"boundary.wall.pressure="}),
              HasSubstr("boundary.wall.pressurised = true: the boundary has no pressure"));
  EXPECT_THAT(coupled_error({"boundary.wall.normal_pressure=1e6"}), HasSubstr("contradicts"));
  EXPECT_THAT(coupled_error({"material.rock.biot_coefficient=-0.5"}), HasSubstr("out of range"));
}

TEST(ReadCoupled, QuasiStaticRunsTakeNoMotionFromOutside) {
  EXPECT_EQ(coupled_error({"time.scheme=quasi_static", "time.tolerance=1e-4", "time.step=1",
                           "time.balance_tolerance=1e-5"}),
            "");
  EXPECT_THAT(coupled_error({"time.scheme=quasi_static", "boundary.wall.velocity_x=1"}),
              HasSubstr("takes no motion of its boundaries"));
  EXPECT_THAT(coupled_error({"time.scheme=quasi_static", "time.stop_ratio=1e-3"}),
              HasSubstr("at rest at every step"));
  EXPECT_THAT(mechanics_error({"time.scheme=quasi_static"}),
              HasSubstr("only coupled runs are quasi-static"));
}

TEST(ReadCoupled, PoresMayBeImplicit) {
  EXPECT_EQ(read(coupled_case).setup.time.pore_flow, simulation::PoreFlow::explicit_);
  const std::string implicit = "time.pore_flow=implicit";
  EXPECT_EQ(read(coupled_case, {implicit}).setup.time.pore_flow, simulation::PoreFlow::implicit);
  EXPECT_EQ(coupled_error({implicit, "time.scheme=explicit", "time.safety=0.5"}), "");
  EXPECT_EQ(coupled_error({"time.pore_flow=steady"}),
            "--set: error: time.pore_flow = \"steady\": no such choice; allowed: \"explicit\", "
            "\"implicit\"");
  EXPECT_EQ(coupled_error({implicit, "time.scheme=quasi_static"}),
            "--set: error: time.pore_flow = \"implicit\": has no effect here: it needs time.scheme "
            "= \"explicit\"");
  EXPECT_THAT(mechanics_error({implicit}), HasSubstr("it needs model.physics = \"coupled\""));
}

TEST(ReadCoupled, OnlyImplicitPoresShareThePressureOfACrack) {
  EXPECT_EQ(coupled_error({"new_cracks.exchange=inf"}),
            "--set: error: new_cracks.exchange = inf: explicit flow in the pores cannot give "
            "fracture and rock one pressure; allowed: a finite exchange, or time.pore_flow = "
            "\"implicit\"");
  EXPECT_EQ(coupled_error({"new_cracks.exchange=inf", "time.pore_flow=implicit"}), "");
}

TEST(ReadCoupled, CracksPressedShutKeepSomeRoom) {
  const auto least = [](const std::vector<std::string>& overrides) {
    const simulation::Setup setup = read(coupled_case, overrides).setup;
    EXPECT_EQ(read(resolved_toml(setup)).setup, setup);
    return setup.new_cracks->fracture.minimum_aperture;
  };
  EXPECT_DOUBLE_EQ(least({}), 1e-5);
  EXPECT_DOUBLE_EQ(least({"new_cracks.minimum_aperture=2e-6"}), 2e-6);
  EXPECT_DOUBLE_EQ(least({"new_cracks.maximum_aperture=3e-6"}), 3e-6);
  EXPECT_DOUBLE_EQ(least({"new_cracks.closure_stress=\"10 MPa\""}), 1e-6);
  const auto fault =
      read(coupled_case, {"fracture.fault.groups=[\"fault\"]",
                          "fracture.fault.initial_aperture=1e-3", "fracture.fault.exchange=1e-9"})
          .setup.fracture.at("fault");
  EXPECT_DOUBLE_EQ(fault.fracture.minimum_aperture, 1e-4);
  EXPECT_EQ(coupled_error({"new_cracks.minimum_aperture=0"}),
            "--set: error: new_cracks.minimum_aperture = 0: fluid in a crack that is pressed shut "
            "would have no room; allowed: > 0 m where rock moves");
}

TEST(ReadCoupled, RestNeedsAPumpThatStops) {
  const auto error = [](const std::string& rate) {
    return coupled_error({"time.stop_ratio=1e-3", "source.pump.point=[0, 0]", rate});
  };
  EXPECT_EQ(error("source.pump.rate=1"),
            "--set: error: time.stop_ratio = 0.001: fluid still flows by source.pump.rate when the "
            "run ends, so it never comes to rest; allowed: a schedule that ends with 0 there, or "
            "time.end alone");
  EXPECT_EQ(error("source.pump.rate={ times = [0, 1e-3], values = [1, 0] }"), "");
  EXPECT_THAT(coupled_error({"time.stop_ratio=1e-3", "boundary.base.flux=1e-6"}),
              HasSubstr("fluid still flows by boundary.base.flux"));
}

TEST(ReadCoupled, OptionsOfCracksNeedCracks) {
  const std::string elastic = "material.rock.joints=elastic";
  std::vector<std::string> whole{elastic, "new_cracks="};
  for (const char* const strength :
       {"tensile_strength", "cohesion", "friction_angle", "mode_1_energy", "mode_2_energy"}) {
    whole.push_back(std::string("material.rock.") + strength + "=");
  }
  const auto error = [&](std::vector<std::string> overrides) {
    overrides.insert(overrides.end(), whole.begin(), whole.end());
    return coupled_error(overrides);
  };
  EXPECT_EQ(error({}), "");
  const std::string needs = "has no effect here: it needs a rock with joints = \"breakable\"";
  EXPECT_THAT(error({"model.fluid_enters=softening"}),
              HasSubstr("fluid_enters = \"softening\": " + needs));
  EXPECT_THAT(error({"model.joint_stress=total"}), HasSubstr("joint_stress = \"total\": " + needs));
  whole[1] = "model.gravity=0";
  EXPECT_THAT(error({}), HasSubstr("new_cracks: " + needs));
}

TEST(ReadCoupled, LimitsOfTheApertureNeedWhatTheyLimit) {
  EXPECT_THAT(coupled_error({"model.crack_storage=clamped"}),
              HasSubstr("it needs a fracture or new cracks with a finite maximum_aperture"));
  const std::vector<std::string> limits{"new_cracks.maximum_aperture=1e-3",
                                        "new_cracks.transmissivity=1e-15"};
  EXPECT_THAT(coupled_error(limits),
              HasSubstr("new_cracks.maximum_aperture = 0.001: has no effect here: it needs the "
                        "cubic law, or model.crack_storage = \"clamped\""));
  EXPECT_EQ(coupled_error({limits[0], limits[1], "model.crack_storage=clamped"}), "");
  EXPECT_EQ(coupled_error({limits[0], "model.crack_storage=clamped"}), "");
}

TEST(ReadCoupled, AnOpeningHasRockRoundIt) {
  EXPECT_EQ(coupled_error({"excavation.all.regions=[\"rock\"]"}),
            "--set: error: excavation.all.regions = [\"rock\"]: leaves no rock: every region of "
            "every material is taken out; allowed: regions that are a part of the model");
  const std::vector<std::string> core{"material.rock.regions=[\"rock\", \"core\"]",
                                      "excavation.core.regions=[\"core\"]",
                                      "excavation.core.pressurised=false"};
  EXPECT_THAT(coupled_error(core), HasSubstr("it needs a pressure other than 0"));
  EXPECT_EQ(coupled_error({core[0], core[1], core[2], "excavation.core.pressure=1e5"}), "");
}

TEST(ReadCoupled, WarnsOfAnUnusualBiotCoefficientWithItsPlace) {
  EXPECT_TRUE(read(coupled_case).warnings.empty());
  std::string low = coupled_case;
  const std::string porosity = "porosity = 0.1\n";
  low.replace(low.find(porosity), porosity.size(), porosity + "biot_coefficient = 0.05\n");
  const std::vector<std::string> warnings = read(low).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
            "case.toml:15:20: warning: material.rock.biot_coefficient = 0.05 is outside of the "
            "range from the porosity, 0.1, to 1 that a rock of solid grains has");
}

/// As coupled_error, for a quasi-static run.
std::string slow_error(std::vector<std::string> overrides) {
  overrides.insert(overrides.begin(), "time.scheme=quasi_static");
  return coupled_error(overrides);
}

TEST(ReadCoupled, FlagsThatAreOffDoNotMoveTheBoundariesOfAQuasiStaticRun) {
  EXPECT_EQ(slow_error({"boundary.wall.absorbing=false"}), "");
  EXPECT_THAT(slow_error({"boundary.base.fixed=", "boundary.base.absorbing=true"}),
              HasSubstr("boundary.base.absorbing = true: a quasi-static run takes no motion"));
}

TEST(ReadCoupled, QuasiStaticRunsNeedAFiniteExchange) {
  EXPECT_THAT(slow_error({"new_cracks.exchange=inf"}),
              HasSubstr("new_cracks.exchange = inf: the quasi-static scheme cannot give"));
  EXPECT_THAT(slow_error({"fracture.fault.groups=[\"fault\"]",
                          "fracture.fault.initial_aperture=1e-4", "fracture.fault.exchange=inf"}),
              HasSubstr("fracture.fault.exchange = inf: the quasi-static scheme cannot give"));
}

TEST(ReadCoupled, ForcesOfAQuasiStaticRunBalanceBetterThanPressuresSettle) {
  const auto slow = [](const std::string& option) {
    return read(coupled_case, {"time.scheme=quasi_static", option}).setup.time;
  };
  EXPECT_DOUBLE_EQ(slow("time.tolerance=1e-5").balance_tolerance.value(), 1e-6);
  EXPECT_EQ(slow("time.balance_tolerance=3e-4").balance_tolerance.value(), 3e-4);
  EXPECT_THAT(slow_error({"time.tolerance=1e-5", "time.balance_tolerance=1e-4"}),
              HasSubstr("time.balance_tolerance = 0.0001: forces out of balance so far keep the "
                        "pressures from settling to 1e-05; allowed: at most 5e-06"));
}

TEST(ReadCoupled, RockInBalanceHasNeitherDampingNorMass) {
  for (const std::string option : {"damping.local=0.5", "time.mass_scaling_step=1e-6"}) {
    EXPECT_THAT(slow_error({option}), HasSubstr("it needs time.scheme = \"explicit\"")) << option;
    EXPECT_EQ(coupled_error({option}), "");
  }
}

TEST(ReadCoupled, AQuasiStaticCaseReadAgainFromItsResolvedFormIsTheSame) {
  for (const std::string more :
       {"time.balance_tolerance=1e-5", "time.tolerance=1e-4", "time.step=1"}) {
    const simulation::Setup setup = read(coupled_case, {"time.scheme=quasi_static", more}).setup;
    EXPECT_EQ(read(resolved_toml(setup)).setup, setup) << resolved_toml(setup);
  }
}

TEST(ReadCoupled, KeepsItsOptionsFromTheHalves) {
  EXPECT_THAT(mechanics_error({"material.rock.biot_coefficient=0.5"}),
              HasSubstr("it needs model.physics = \"coupled\""));
  EXPECT_THAT(mechanics_error({"material.rock.porosity=0.5"}),
              HasSubstr("it needs model.physics = \"seepage\" or \"coupled\""));
  EXPECT_THAT(coupled_error({"time.tolerance=1e-4"}),
              HasSubstr("it needs time.scheme = \"implicit\" or \"quasi_static\""));
}

}  // namespace
}  // namespace percolith::case_file
