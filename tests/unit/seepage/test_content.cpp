// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/content.hpp"

#include <gtest/gtest.h>

namespace percolith::seepage {
namespace {

constexpr double storage = 2e-12;
constexpr double voids = 3e-3;
constexpr double cavitation = -5e4;

FluidState<double> state_of(double excess, double growth = 0.0) {
  return fluid_state(excess, growth, storage, voids, cavitation, true);
}

TEST(FluidState, AFullNodeIsAtThePressureItsExcessCompressesItTo) {
  const auto fluid = state_of(4e-7);
  EXPECT_DOUBLE_EQ(fluid.pressure, cavitation + 4e-7 / storage);
  EXPECT_EQ(fluid.saturation, 1.0);
}

TEST(FluidState, ANodeShortOfFluidEmptiesAtTheCavitationPressure) {
  const auto fluid = state_of(-0.25 * voids);
  EXPECT_EQ(fluid.pressure, cavitation);
  EXPECT_DOUBLE_EQ(fluid.saturation, 0.75);
  EXPECT_DOUBLE_EQ(state_of(-voids).saturation, 0.0);
}

TEST(FluidState, GrowthOfTheVoidsLowersPressureThenSaturation) {
  EXPECT_DOUBLE_EQ(state_of(4e-7, 1e-7).pressure, cavitation + 3e-7 / storage);
  // s = (V0 + w)/(V0 + growth)
  const auto fluid = state_of(1e-4, 1e-3);
  EXPECT_EQ(fluid.pressure, cavitation);
  EXPECT_DOUBLE_EQ(fluid.saturation, (voids + 1e-4) / (voids + 1e-3));
}

TEST(FluidState, IsContinuousWhereTheNodeBecomesFull) {
  for (const double growth : {0.0, 1e-4, -1e-4}) {
    const auto below = state_of(growth - 1e-18, growth);
    const auto above = state_of(growth + 1e-18, growth);
    EXPECT_NEAR(below.pressure, above.pressure, 1e-3);
    EXPECT_NEAR(below.saturation, above.saturation, 1e-12);
    EXPECT_EQ(state_of(growth, growth).saturation, 1.0);
  }
}

TEST(FluidState, ANodeThatCannotEmptyTakesAnySuction) {
  const auto fluid = fluid_state(-4e-7, 1e-7, storage, voids, 0.0, false);
  EXPECT_DOUBLE_EQ(fluid.pressure, -5e-7 / storage);
  EXPECT_EQ(fluid.saturation, 1.0);
}

TEST(ExcessOf, IsTheInverseOfTheStateEquation) {
  for (const double growth : {0.0, 2e-4}) {
    for (const double excess : {3e-7, 1e-6, 0.0, -1e-6, -1e-3, -2.9e-3}) {
      const double back =
          excess_of(state_of(excess + growth, growth), growth, storage, voids, cavitation);
      EXPECT_NEAR(back, excess + growth, 1e-15 * voids);
    }
  }
}

TEST(SaturationWeight, RisesFromZeroToOneWithFlatEnds) {
  EXPECT_EQ(saturation_weight(0.0), 0.0);
  EXPECT_EQ(saturation_weight(1.0), 1.0);
  EXPECT_EQ(saturation_weight(0.5), 0.5);
  EXPECT_DOUBLE_EQ(saturation_weight(0.2), 0.04 * 2.6);
  EXPECT_NEAR(saturation_weight(1e-6), 0.0, 1e-11);
  EXPECT_NEAR(saturation_weight(1.0 - 1e-6), 1.0, 1e-11);
}

}  // namespace
}  // namespace percolith::seepage
