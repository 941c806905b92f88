// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/time/schedule.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace percolith {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

TEST(Schedule, ConstantIsOneValueForEver) {
  const Schedule s = Schedule::constant(4.5);
  EXPECT_TRUE(s.is_constant());
  for (const double t : {-1e9, 0.0, 1e9}) {
    EXPECT_EQ(s.at(t), 4.5);
    EXPECT_EQ(s.next_break(t), never);
  }
  EXPECT_EQ(Schedule{}.at(3.0), 0.0);
}

TEST(Schedule, LinearTableInterpolatesAndKeepsItsEnds) {
  const Schedule s{{1.0, 3.0, 4.0}, {10.0, 20.0, -20.0}, Interpolation::linear};
  EXPECT_FALSE(s.is_constant());
  EXPECT_EQ(s.at(-5.0), 10.0);
  EXPECT_EQ(s.at(1.0), 10.0);
  EXPECT_EQ(s.at(1.5), 12.5);
  EXPECT_EQ(s.at(3.0), 20.0);
  EXPECT_EQ(s.at(3.5), 0.0);
  EXPECT_EQ(s.at(4.0), -20.0);
  EXPECT_EQ(s.at(99.0), -20.0);
}

TEST(Schedule, StepTableTakesTheNewValueAtItsTime) {
  const Schedule s{{0.0, 2.0, 5.0}, {1.0, 7.0, 3.0}, Interpolation::step};
  EXPECT_EQ(s.at(-1.0), 1.0);
  EXPECT_EQ(s.at(1.999), 1.0);
  EXPECT_EQ(s.at(2.0), 7.0);
  EXPECT_EQ(s.at(4.999), 7.0);
  EXPECT_EQ(s.at(5.0), 3.0);
  EXPECT_EQ(s.at(6.0), 3.0);
}

TEST(Schedule, BreaksAreTheTimesOfItsTable) {
  for (const auto interpolation : {Interpolation::linear, Interpolation::step}) {
    const Schedule s{{0.0, 2.0, 5.0}, {1.0, 7.0, 3.0}, interpolation};
    EXPECT_EQ(s.next_break(-1.0), 0.0);
    EXPECT_EQ(s.next_break(0.0), 2.0);
    EXPECT_EQ(s.next_break(1.999), 2.0);
    EXPECT_EQ(s.next_break(2.0), 5.0);
    EXPECT_EQ(s.next_break(5.0), never);
  }
}

}  // namespace
}  // namespace percolith
