// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/execution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace percolith {
namespace {

std::size_t slots(std::int32_t n) {
  return static_cast<std::size_t>(padded(n));
}

struct Curve {
  static constexpr bool vectorised = true;
  const double* x;
  double* y;
  template <class Lane>
  void operator()(Lane lane) const {
    using Real = typename Lane::Real;
    const Real value = Lane::load(x + lane.first);
    const Real bent = value * value * (Real(3.0) - Real(2.0) * value) / (value + Real(0.1));
    Lane::store(y + lane.first, select(value > Real(0.5), bent, -bent));
  }
};

struct Count {
  int* visits;
  void operator()(ScalarLane lane) const { ++visits[lane.first]; }
};

TEST(Padding, RoundsUpToWholeBlocks) {
  EXPECT_EQ(padded(0), 0);
  EXPECT_EQ(padded(1), block_width);
  EXPECT_EQ(padded(block_width), block_width);
  EXPECT_EQ(padded(block_width + 1), 2 * block_width);
}

TEST(Execution, VectorKernelsGiveTheBitsOfTheSerialReference) {
  constexpr std::int32_t n = 10'001;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> value(0.0, 1.0);
  std::vector<double> x(slots(n));
  for (double& v : x) {
    v = value(random);
  }
  std::vector<double> reference(slots(n));
  Execution(Backend::serial).for_each("curve", n, Curve{x.data(), reference.data()});
  EXPECT_EQ(reference[0], x[0] > 0.5 ? x[0] * x[0] * (3 - 2 * x[0]) / (x[0] + 0.1)
                                     : -(x[0] * x[0] * (3 - 2 * x[0]) / (x[0] + 0.1)));
  for (const int threads : {1, 2, 3}) {
    std::vector<double> y(slots(n));
    Execution(Backend::host, threads).for_each("curve", n, Curve{x.data(), y.data()});
    EXPECT_EQ(y, reference) << threads;
  }
}

TEST(Execution, VisitsEveryElementOnce) {
  for (const std::int32_t n : {0, 1, 7, 9, 5000}) {
    for (const int threads : {1, 2}) {
      std::vector<int> visits(static_cast<std::size_t>(n) + 1, 0);
      Execution(Backend::host, threads).for_each("count", n, Count{visits.data()});
      for (std::int32_t i = 0; i < n; ++i) {
        ASSERT_EQ(visits[static_cast<std::size_t>(i)], 1);
      }
      EXPECT_EQ(visits.back(), 0);
    }
  }
}

TEST(Execution, SumsAreTheSameBitsForAnyNumberOfThreads) {
  constexpr std::int32_t n = 12'345;
  std::mt19937 random(2);
  std::vector<double> x(n);
  for (double& v : x) {
    v = std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 60) - 30);
  }
  const auto term = [&](std::int32_t i) { return x[static_cast<std::size_t>(i)]; };
  long double exact = 0.0L;
  for (const double v : x) {
    exact += static_cast<long double>(v);
  }
  const double one = Execution(Backend::host, 1).sum(n, term);
  EXPECT_NEAR(one, static_cast<double>(exact), 1e-12 * one);
  EXPECT_EQ(Execution(Backend::host, 2).sum(n, term), one);
  EXPECT_EQ(Execution(Backend::host, 5).sum(n, term), one);
  EXPECT_EQ(Execution(Backend::serial).sum(n, term), one);
  EXPECT_EQ(Execution().sum(0, term), 0.0);
  EXPECT_EQ(Execution().sum(1024, [](std::int32_t) { return 1.0; }), 1024.0);
  EXPECT_EQ(Execution().sum(1025, [](std::int32_t) { return 1.0; }), 1025.0);
}

TEST(Execution, BooksWallTimeByName) {
  Execution execution;
  std::vector<int> visits(1, 0);
  execution.for_each("first", 1, Count{visits.data()});
  execution.for_each("first", 1, Count{visits.data()});
  execution.book("second", std::chrono::steady_clock::now() - std::chrono::seconds(3));
  ASSERT_EQ(execution.wall_time().size(), 2u);
  EXPECT_GE(execution.wall_time().at("first"), 0.0);
  EXPECT_NEAR(execution.wall_time().at("second"), 3.0, 0.5);
}

}  // namespace
}  // namespace percolith
