// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/time/step_control.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace percolith {
namespace {

TEST(StepControl, StartsWithTheFirstStepButNotAboveTheLargest) {
  EXPECT_EQ(StepControl(1e-3, 0.5, 10.0).step(), 0.5);
  EXPECT_EQ(StepControl(1e-3, 50.0, 10.0).step(), 10.0);
}

TEST(StepControl, RejectsTooLargeAnErrorAndShrinksByItsSquareRoot) {
  StepControl control(1e-3, 1.0, 10.0);
  EXPECT_FALSE(control.judge(1.0, 4e-3));
  EXPECT_NEAR(control.step(), 0.9 * 0.5, 1e-15);
  // Never by more than ten at once.
  EXPECT_FALSE(control.judge(1.0, 1e6));
  EXPECT_NEAR(control.step(), 0.1, 1e-15);
}

TEST(StepControl, AnErrorOfSecondOrderIsAcceptedAfterOneRejection) {
  StepControl control(1e-3, 1.0, 10.0);
  const auto error = [](double dt) { return 0.02 * dt * dt; };
  EXPECT_FALSE(control.judge(1.0, error(1.0)));
  EXPECT_TRUE(control.judge(control.step(), error(control.step())));
}

TEST(StepControl, DoublesOnlyWhenTheDoubleWouldBeGood) {
  StepControl control(1e-3, 1.0, 10.0);
  // The error of twice the step is four times as large; with the margin of 0.9 squared.
  EXPECT_TRUE(control.judge(1.0, 1e-3 * 0.81 / 4.0 * 1.001));
  EXPECT_EQ(control.step(), 1.0);
  EXPECT_TRUE(control.judge(1.0, 1e-3 * 0.81 / 4.0 * 0.999));
  EXPECT_EQ(control.step(), 2.0);
  EXPECT_TRUE(control.judge(2.0, 0.0));
  EXPECT_TRUE(control.judge(4.0, 0.0));
  EXPECT_TRUE(control.judge(8.0, 0.0));
  EXPECT_EQ(control.step(), 10.0);
}

TEST(StepControl, AStepCutShortDoesNotShrinkTheNext) {
  StepControl control(1e-3, 1.0, 10.0);
  EXPECT_TRUE(control.judge(0.01, 1e-9));
  EXPECT_EQ(control.step(), 1.0);
}

TEST(StepControl, AFailureQuartersTheStep) {
  StepControl control(1e-3, 1.0, 10.0);
  control.failed(0.8);
  EXPECT_EQ(control.step(), 0.2);
}

TEST(StepControl, AGivenStepComesBackAfterAFailure) {
  StepControl control(std::numeric_limits<double>::infinity(), 2.0, 2.0);
  EXPECT_TRUE(control.judge(2.0, 1e30));
  EXPECT_EQ(control.step(), 2.0);
  control.failed(2.0);
  EXPECT_TRUE(control.judge(0.5, 1e30));
  EXPECT_TRUE(control.judge(1.0, 1e30));
  EXPECT_EQ(control.step(), 2.0);
}

TEST(StepControl, TheSmallestStepIsGoodWhateverItsError) {
  StepControl control(1e-3, 1.0, 10.0, 0.05);
  double dt = control.step();
  int rejections = 0;
  while (!control.judge(dt, 0.5)) {  // an error that does not fall with the step
    dt = step_towards(0.0, 1e3, control.step());
    ASSERT_LT(++rejections, 10);
  }
  EXPECT_EQ(dt, 0.05);
  EXPECT_EQ(control.step(), 0.05);
  // Also when an event stretches it by round-off, and it grows again as soon as the error is small.
  EXPECT_TRUE(control.judge(0.05 * (1.0 + 1e-9), 0.5));
  EXPECT_TRUE(control.judge(0.05, 1e-5));
  EXPECT_EQ(control.step(), 0.1);
}

TEST(StepTowards, MeetsEventsWithoutSlivers) {
  EXPECT_EQ(step_towards(0.0, 100.0, 1.0), 1.0);
  EXPECT_EQ(step_towards(99.0, 100.0, 1.0), 1.0);
  EXPECT_EQ(step_towards(98.5, 100.0, 1.0), 0.75);
  EXPECT_EQ(step_towards(99.5, 100.0, 1.0), 0.5);
  EXPECT_EQ(step_towards(0.0, std::numeric_limits<double>::infinity(), 3.0), 3.0);
  // A rest longer than the step by round-off only is one step.
  EXPECT_EQ(step_towards(0.0, 1.0 + 1e-12, 1.0), 1.0 + 1e-12);
}

TEST(StepTowards, ReachesEveryEventInStepsOfAtLeastHalf) {
  double time = 0.0;
  int steps = 0;
  while (time < 10.0) {
    const double step = step_towards(time, 10.0, 0.3);
    EXPECT_GE(step, 0.15 - 1e-12);
    EXPECT_LE(step, 0.3 * (1.0 + 1e-9));
    time = step >= 10.0 - time ? 10.0 : time + step;
    ASSERT_LT(++steps, 40);
  }
  EXPECT_EQ(time, 10.0);
  EXPECT_EQ(steps, 34);
}

}  // namespace
}  // namespace percolith
