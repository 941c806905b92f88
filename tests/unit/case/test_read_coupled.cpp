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

TEST(ReadCoupled, TheMotionOfAQuasiStaticRunIsDampedUnlessTold) {
  const auto local = [](const std::vector<std::string>& options) {
    return read(coupled_case, options).setup.damping.local;
  };
  EXPECT_EQ(local({"time.scheme=quasi_static"}), 0.7);
  EXPECT_EQ(local({"time.scheme=quasi_static", "damping.nodal_viscosity=1"}), 0.7);
  EXPECT_EQ(local({"time.scheme=quasi_static", "damping.local=0"}), 0.0);
  EXPECT_FALSE(local({}).has_value());
}

TEST(ReadCoupled, AQuasiStaticCaseReadAgainFromItsResolvedFormIsTheSame) {
  for (const std::string more : {"damping.local=0", "time.tolerance=1e-4", "time.step=1"}) {
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
