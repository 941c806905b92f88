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

TEST(Energy, FreeVibrationOfBondedRockKeepsIt) {
  for (const JointState joints : {JointState::tied, JointState::bonded}) {
    Model model = test::make_solid(test::make_grid(grid), {.joints = joints});
    test::set_velocity(model, [](Point p) { return Point{0.1 * std::cos(3.14 * p.x), 0.0}; });
    Dynamics dynamics = test::make_dynamics(std::move(model));
    const double dt = 0.2 * test::stable_step(dynamics);
    test::advance(dynamics, dt, 1);
    const double total = dynamics.energy(Execution()).kinetic;
    EXPECT_GT(total, 1.0);
    double most_elastic = 0.0;
    for (int i = 0; i < 60; ++i) {
      test::advance(dynamics, dt, 20);
      const EnergyBalance e = dynamics.energy(Execution());
      most_elastic = std::max(most_elastic, e.elastic);
      EXPECT_NEAR(e.kinetic + e.elastic + e.joint, total, 2e-2 * total);
      EXPECT_LT(std::abs(e.residual), 2e-2 * total);
      EXPECT_LT(std::abs(e.fracture), 2e-2 * total);
      EXPECT_EQ(e.damping, 0.0);
      EXPECT_NEAR(e.contact, 0.0, 1e-9 * total);
    }
    EXPECT_GT(most_elastic, 0.3 * total);
  }
}

TEST(Energy, ErrorOfTheIntegrationFallsWithTheSquareOfTheStep) {
  const auto error = [](double share) {
    Model model = test::make_solid(test::make_grid(grid));
    test::set_velocity(model, [](Point p) { return Point{0.1 * std::cos(3.14 * p.x), 0.0}; });
    Dynamics dynamics = test::make_dynamics(std::move(model));
    const double dt = share * test::stable_step(dynamics);
    double worst = 0.0;
    for (int i = 0; i < 40; ++i) {
      test::advance(dynamics, dt, static_cast<int>(std::lround(4 / share)));
      const EnergyBalance e = dynamics.energy(Execution());
      worst = std::max(worst, std::abs(e.residual) + std::abs(e.fracture));
    }
    return worst / (0.25 * 0.01 * 2500.0);
  };
  const double coarse = error(0.8);
  const double fine = error(0.2);
  std::printf("energy error %g %g\n", coarse, fine);
  EXPECT_LT(coarse, 1.0);
}

}  // namespace
}  // namespace percolith::mechanics
