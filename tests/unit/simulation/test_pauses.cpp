// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/pause.hpp"

#include <gtest/gtest.h>

namespace percolith::simulation {
namespace {

TEST(Pauses, AreReachedByTimeByStepsOrByAnOutput) {
  const PauseClock never({}, 5);
  EXPECT_FALSE(never.over(1e300, 1'000'000, true));
  const PauseClock time({.time = 2.0}, 5);
  EXPECT_FALSE(time.over(1.9, 9, false));
  EXPECT_TRUE(time.over(2.0, 9, false));
  const PauseClock steps({.steps = 3}, 5);
  EXPECT_FALSE(steps.over(0.0, 7, false));
  EXPECT_TRUE(steps.over(0.0, 8, false));
}

TEST(Pauses, TheOutputAtWhichARunWaitsIsNotTheNext) {
  const PauseClock output({.at_output = true}, 5);
  EXPECT_FALSE(output.over(0.0, 5, true));
  EXPECT_FALSE(output.over(0.0, 6, false));
  EXPECT_TRUE(output.over(0.0, 6, true));
}

}  // namespace
}  // namespace percolith::simulation
