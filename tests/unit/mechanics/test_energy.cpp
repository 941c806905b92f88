// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/energy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "unit/support/solid_model.hpp"

namespace percolith::mechanics {
namespace {

using test::at;

const test::Grid grid{.columns = 6, .rows = 6, .jitter = 0.15, .seed = 2, .mixed_diagonals = true};

/// A bar that is let go with a wave in it, share of the stable step; the energy it has.
Dynamics vibrating(JointState joints, double& energy) {
  Model model = test::make_solid(test::make_grid(grid), {.joints = joints});
  test::set_velocity(model, [](Point p) { return Point{0.1 * std::cos(3.14 * p.x), 0.0}; });
  Dynamics dynamics = test::make_dynamics(std::move(model));
  energy = dynamics.energy(Execution()).kinetic;
  return dynamics;
}

TEST(Energy, FreeVibrationOfBondedRockKeepsIt) {
  for (const JointState joints : {JointState::tied, JointState::bonded}) {
    double total = 0.0;
    Dynamics dynamics = vibrating(joints, total);
    EXPECT_GT(total, 1.0);
    const double dt = 0.2 * test::stable_step(dynamics);
    double most_elastic = 0.0;
    for (int i = 0; i < 60; ++i) {
      test::advance(dynamics, dt, 20);
      const EnergyBalance e = dynamics.energy(Execution());
      most_elastic = std::max(most_elastic, e.elastic);
      EXPECT_NEAR(e.kinetic + e.elastic + e.joint, total, 1e-3 * total);
      EXPECT_LT(std::abs(e.residual), 1e-3 * total);
      EXPECT_LT(std::abs(e.fracture), 1e-3 * total);
      EXPECT_EQ(e.damping, 0.0);
      EXPECT_EQ(e.external, 0.0);
      EXPECT_NEAR(e.contact, 0.0, 1e-9 * total);
    }
    EXPECT_GT(most_elastic, 0.3 * total);
  }
}

TEST(Energy, ErrorOfTheIntegrationFallsWithTheSquareOfTheStep) {
  const auto error = [](double share) {
    double total = 0.0;
    Dynamics dynamics = vibrating(JointState::bonded, total);
    const double dt = share * test::stable_step(dynamics);
    double worst = 0.0;
    for (int i = 0; i < 100; ++i) {
      test::advance(dynamics, dt, static_cast<int>(std::lround(4 / share)));
      const EnergyBalance e = dynamics.energy(Execution());
      worst = std::max(worst, std::abs(e.kinetic + e.elastic + e.joint - total));
    }
    return worst / total;
  };
  const double coarse = error(0.8);
  const double fine = error(0.2);
  EXPECT_LT(coarse, 1e-2);
  EXPECT_LT(fine, coarse / 8);
}

TEST(Energy, IsCompleteBeforeTheFirstStep) {
  Model model = test::make_solid(test::make_grid(grid));
  test::set_velocity(model, [](Point) { return Point{2.0, 0.0}; });
  set_initial_stress(model, [](Point) { return Tensor{-1e6, -2e6, 0.0}; });
  const EnergyBalance e = test::make_dynamics(std::move(model)).energy(Execution());
  EXPECT_NEAR(e.kinetic, 0.5 * 2500.0 * 4.0, 1e-9);
  EXPECT_EQ(e.residual, 0.0);
  EXPECT_EQ(e.fracture, 0.0);
}

TEST(Energy, PartsAreBookedWhereTheyBelong) {
  // A block pulled by a traction and dropped, with every kind of damping.
  Model model = test::make_solid(test::make_grid(grid),
                                 {.gravity = 9.81, .damping = {1e5, 0.2}, .viscosity_ratio = 0.1});
  LoadList loads;
  loads.traction.push_back(
      {test::edges_of(model, "right"), Schedule::constant(1e5), Schedule::constant(0.0)});
  std::vector<Held> held;
  test::hold_where(
      model, [](Point p) { return p.x == 0.0; }, {1.0, 0.0}, 0, held);
  SupportSet supports(
      model, {{"left", PrescribedMotion::Kind::velocity, Schedule::constant(-0.01)}}, held);
  Dynamics dynamics = test::make_dynamics(std::move(model), std::move(loads), std::move(supports));
  test::advance(dynamics, 0.3 * test::stable_step(dynamics), 2000);
  const EnergyBalance e = dynamics.energy(Execution());
  EXPECT_GT(e.gravity, 0.0);
  EXPECT_GT(e.external, 0.0);
  EXPECT_GT(e.damping, 0.0);
  EXPECT_GT(e.elastic, 0.0);
  EXPECT_GT(e.joint, 0.0);
  EXPECT_EQ(e.friction, 0.0);
  EXPECT_LT(std::abs(e.residual), 1e-3 * (e.gravity + e.external));
  EXPECT_LT(std::abs(e.fracture), 1e-3 * (e.gravity + e.external));
}

}  // namespace
}  // namespace percolith::mechanics
