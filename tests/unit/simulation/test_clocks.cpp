// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/event_clock.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace percolith::simulation {
namespace {

std::vector<double> all_times(const Output& output, double end) {
  const EventClock clock(output, end);
  std::vector<double> times;
  for (double t = clock.next_output(0.0); t < std::numeric_limits<double>::infinity();
       t = clock.next_output(t)) {
    times.push_back(t);
  }
  return times;
}

TEST(EventClock, TheEndIsAlwaysAnOutput) {
  EXPECT_EQ(all_times({}, 7.5), (std::vector<double>{7.5}));
}

TEST(EventClock, ListAndIntervalTogetherWithinTheRun) {
  Output output;
  output.times = {3.5, 0.0, 1.5, -2.0, 99.0, 3.5};
  output.interval = 2.0;
  EXPECT_EQ(all_times(output, 5.0), (std::vector<double>{1.5, 2.0, 3.5, 4.0, 5.0}));
}

TEST(EventClock, TimesThatDifferByRoundOffAreOne) {
  Output output;
  output.interval = 0.1;
  EXPECT_EQ(all_times(output, 1.0).size(), 10u);
  output.times = {0.3, 0.6, 0.7, 0.9999999999999999};  // multiples of 0.1 miss these by a digit
  const auto times = all_times(output, 1.0);
  ASSERT_EQ(times.size(), 10u);
  EXPECT_EQ(times.back(), 1.0);
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_NEAR(times[i], 0.1 * static_cast<double>(i + 1), 1e-15);
  }
}

TEST(HistoryClock, IsAlwaysDueWithoutAnInterval) {
  HistoryClock clock(0.0);
  EXPECT_TRUE(clock.due(0.0));
  EXPECT_TRUE(clock.due(0.5));
  EXPECT_TRUE(clock.due(0.6));
}

TEST(HistoryClock, IsDueOnceAnInterval) {
  HistoryClock clock(1.0);
  EXPECT_TRUE(clock.due(0.0));
  EXPECT_FALSE(clock.due(0.4));
  EXPECT_FALSE(clock.due(0.999));
  EXPECT_TRUE(clock.due(1.0));
  EXPECT_FALSE(clock.due(1.5));
  EXPECT_TRUE(clock.due(3.7));  // steps may be longer than the interval
  EXPECT_FALSE(clock.due(3.9));
  EXPECT_TRUE(clock.due(4.0));
}

TEST(HistoryClock, MultiplesThatRoundOffMissesCount) {
  HistoryClock clock(0.1);
  int rows = 0;
  for (int i = 0; i <= 1000; ++i) {
    rows += clock.due(0.01 * i) ? 1 : 0;
  }
  EXPECT_NEAR(rows, 101, 1);
}

}  // namespace
}  // namespace percolith::simulation
