// SPDX-License-Identifier: BSD-3-Clause
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
  EXPECT_EQ(coupled_error({"new_cracks.exchange=inf", "time.scheme=quasi_static"}), "");
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
