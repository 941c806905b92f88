// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/execution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

namespace percolith {
namespace {

std::vector<double> numbers(std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  std::vector<double> x(n);
  for (double& v : x) {
    v = std::ldexp(value(random), static_cast<int>(random() % 40));
  }
  return x;
}

/// Sums the values and their squares and finds the largest value.
struct Moments {
  static constexpr bool vectorised = true;
  const double* x;
  template <class Lane>
  void operator()(Lane lane, LaneSums<2>& sums) const {
    const auto v = Lane::load(x + lane.first);
    sums.add(0, lane, v);
    sums.add(1, lane, v * v);
    sums.raise(lane, v);
  }
};

/// Counts what it is called with, one after the other.
struct Tally {
  void operator()(ScalarLane lane, LaneSums<1>& sums) const {
    sums.add(0, lane, 1.0 + lane.first);
    sums.raise(lane, static_cast<double>(lane.first));
  }
};

TEST(LaneSums, AreTheSameBitsOnAnyBackendAndNumberOfThreads) {
  constexpr std::int32_t n = 40'003;
  std::vector<double> x = numbers(static_cast<std::size_t>(n), 6);
  x.resize(static_cast<std::size_t>(padded(n)), 0.0);
  const auto reference = Execution(Backend::serial).sum_each<2>("moments", n, Moments{x.data()});
  long double sum = 0.0L;
  long double squares = 0.0L;
  for (const double v : x) {
    sum += static_cast<long double>(v);
    squares += static_cast<long double>(v) * static_cast<long double>(v);
  }
  EXPECT_NEAR(reference.sum[0], static_cast<double>(sum), 1e-12 * std::ldexp(n, 40));
  EXPECT_NEAR(reference.sum[1] / static_cast<double>(squares), 1.0, 1e-12);
  EXPECT_EQ(reference.peak, *std::max_element(x.begin(), x.end()));
  for (const int threads : {1, 2, 3}) {
    Execution execution(Backend::host, threads);
    const auto totals = execution.sum_each<2>("moments", n, Moments{x.data()});
    EXPECT_EQ(totals.sum, reference.sum) << threads;
    EXPECT_EQ(totals.peak, reference.peak) << threads;
  }
}

TEST(LaneSums, KernelsOfSingleElementsLeaveThePaddingOut) {
  for (const std::int32_t n : {0, 1, 9, 512, 513, 5000}) {
    Execution execution(Backend::host, 2);
    const auto totals = execution.sum_each<1>("tally", n, Tally{});
    EXPECT_EQ(totals.sum[0], 0.5 * n * (n + 1.0));
    EXPECT_EQ(totals.peak, n > 0 ? n - 1.0 : 0.0);
    EXPECT_EQ(execution.wall_time().count("tally"), 1u);
  }
}

TEST(LaneSums, ASecondLoopForgetsTheFirst) {
  Execution execution;
  static_cast<void>(execution.sum_each<1>("tally", 5000, Tally{}));
  EXPECT_EQ(execution.sum_each<1>("tally", 3, Tally{}).sum[0], 6.0);
  EXPECT_EQ(execution.sum_each<1>("tally", 3, Tally{}).peak, 2.0);
}

TEST(LaneSums, PeakStartsAtZero) {
  std::vector<double> x(8, -3.0);
  Execution execution;
  EXPECT_EQ(execution.sum_each<2>("moments", 8, Moments{x.data()}).peak, 0.0);
}

/// The values at indices as one lane sees them.
template <class Lane, class Read>
std::vector<double> read_block(const Read& read) {
  std::vector<double> values(block_width);
  for (std::int32_t i = 0; i < block_width; i += Lane::width) {
    Lane::store(values.data() + i, read(Lane{i}));
  }
  return values;
}

TEST(Lanes, GatherSignedFlipsAndNegatesByTheCode) {
  const std::vector<double> x = numbers(64, 7);
  const std::vector<std::int32_t> code{3, 20, 0, 16, 47, 40, 63, 5};
  for (const std::int32_t flip : {0, 16, 5}) {
    std::vector<double> expected;
    for (const std::int32_t c : code) {
      const double value = x[static_cast<std::size_t>(c ^ flip)];
      expected.push_back(c % 32 >= 16 ? -value : value);
    }
    const auto read = [&](auto lane) {
      using Lane = decltype(lane);
      return Lane::gather_signed(x.data(), code.data() + lane.first, flip, 16);
    };
    EXPECT_EQ(read_block<ScalarLane>(read), expected) << flip;
    EXPECT_EQ(read_block<VectorLane>(read), expected) << flip;
  }
}

TEST(Lanes, GenerateAsksForEveryElement) {
  const auto read = [](auto lane) {
    using Lane = decltype(lane);
    return Lane::generate([&](std::int32_t i) { return 10.0 + lane.first + i; });
  };
  std::vector<double> expected(block_width);
  std::iota(expected.begin(), expected.end(), 10.0);
  EXPECT_EQ(read_block<ScalarLane>(read), expected);
  EXPECT_EQ(read_block<VectorLane>(read), expected);
}

TEST(Lanes, GatherReadsBySlot) {
  const std::vector<double> x = numbers(64, 8);
  const std::vector<std::int32_t> slot{9, 1, 63, 0, 7, 7, 30, 2};
  std::vector<double> expected;
  for (const std::int32_t s : slot) {
    expected.push_back(x[static_cast<std::size_t>(s)]);
  }
  const auto read = [&](auto lane) {
    using Lane = decltype(lane);
    return Lane::gather(x.data(), slot.data() + lane.first);
  };
  EXPECT_EQ(read_block<ScalarLane>(read), expected);
  EXPECT_EQ(read_block<VectorLane>(read), expected);
}

}  // namespace
}  // namespace percolith
