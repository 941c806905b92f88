// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/execution.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
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

/// Doubles every third element: picks them, and puts them back by their numbers.
struct EveryThird {
  double* x;
  template <class Lane>
  void operator()(Lane lane, std::int32_t end) const {
    std::vector<std::int32_t> picked;
    for (std::int32_t i = lane.first; i < end; ++i) {
      if (i % 3 == 0) {
        picked.push_back(i);
      }
    }
    const std::size_t count = picked.size();
    if (count == 0) {
      return;
    }
    picked.resize(count + block_width, picked.back());
    for (std::size_t k = 0; k < count; k += Lane::width) {
      const auto value = Lane::gather(x, &picked[k]);
      Lane::scatter(x, &picked[k], value + value);
    }
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

TEST(Execution, ChunksMayPickTheirElements) {
  constexpr std::int32_t n = 5001;
  for (const auto& [backend, threads] :
       {std::pair{Backend::serial, 1}, {Backend::host, 1}, {Backend::host, 2}}) {
    std::vector<double> x(n);
    for (std::int32_t i = 0; i < n; ++i) {
      x[static_cast<std::size_t>(i)] = i;
    }
    Execution(backend, threads).for_each_chunk("chunks", n, 40, EveryThird{x.data()});
    for (std::int32_t i = 0; i < n; ++i) {
      ASSERT_EQ(x[static_cast<std::size_t>(i)], i % 3 == 0 ? 2.0 * i : i);
    }
  }
}

template <class Lane>
std::array<double, 2> extremes(double a, double b) {
  std::array<double, block_width> out;
  Lane::store(out.data(), larger(typename Lane::Real(a), typename Lane::Real(b)));
  const double most = out[0];
  Lane::store(out.data(), smaller(typename Lane::Real(a), typename Lane::Real(b)));
  return {most, out[0]};
}

TEST(Lanes, AFirstArgumentThatIsNoNumberLosesAndOfEqualZerosTheSecondIsTaken) {
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  for (const auto& find : {extremes<ScalarLane>, extremes<VectorLane>}) {
    EXPECT_EQ(find(1.0, 2.0), (std::array{2.0, 1.0}));
    EXPECT_EQ(find(nothing, 2.0), (std::array{2.0, 2.0}));
    EXPECT_TRUE(std::isnan(find(2.0, nothing)[0]) && std::isnan(find(2.0, nothing)[1]));
    EXPECT_TRUE(std::signbit(find(0.0, -0.0)[0]) && std::signbit(find(0.0, -0.0)[1]));
    EXPECT_FALSE(std::signbit(find(-0.0, 0.0)[0]) || std::signbit(find(-0.0, 0.0)[1]));
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
