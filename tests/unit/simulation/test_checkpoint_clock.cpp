// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/checkpoints.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace percolith::simulation {
namespace {

using std::chrono::seconds;

TEST(CheckpointClock, FollowsTheTimeOfTheSimulation) {
  Output output;
  output.checkpoint_interval = 0.5;
  output.checkpoint_wall_interval = 0.0;
  const CheckpointClock::Wall now{};
  CheckpointClock clock(output, 0.0, now);
  EXPECT_FALSE(clock.due(0.4, now + seconds(1'000'000)));
  EXPECT_TRUE(clock.due(0.5, now));
  clock.written(1.1, now, now);
  EXPECT_FALSE(clock.due(1.4, now));
  EXPECT_TRUE(clock.due(1.5, now));
  // A run that goes on keeps to the same multiples.
  EXPECT_FALSE(CheckpointClock(output, 1.1, now).due(1.4, now));
  EXPECT_TRUE(CheckpointClock(output, 1.1, now).due(1.5, now));
}

TEST(CheckpointClock, FollowsTheClockOnTheWallAndSpendsAHundredthAtMost) {
  Output output;
  output.checkpoint_wall_interval = 60.0;
  const CheckpointClock::Wall now{};
  CheckpointClock clock(output, 0.0, now);
  EXPECT_FALSE(clock.due(1e9, now + seconds(59)));
  EXPECT_TRUE(clock.due(0.0, now + seconds(60)));
  clock.written(0.0, now + seconds(60), now + seconds(61));
  EXPECT_FALSE(clock.due(0.0, now + seconds(160)));
  EXPECT_TRUE(clock.due(0.0, now + seconds(161)));
}

TEST(CheckpointClock, IsNeverDueWithoutIntervals) {
  Output output;
  output.checkpoint_wall_interval = 0.0;
  const CheckpointClock::Wall now{};
  EXPECT_FALSE(CheckpointClock(output, 0.0, now).due(1e300, now + seconds(1'000'000'000)));
  output.checkpoint_wall_interval = 1e300;
  EXPECT_FALSE(CheckpointClock(output, 0.0, now).due(1e300, now + seconds(200'000'000)));
}

}  // namespace
}  // namespace percolith::simulation
