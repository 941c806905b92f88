// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/compensated.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace percolith {
namespace {

TEST(CompensatedSum, KeepsWhatAPlainSumLoses) {
  CompensatedSum sum{1.0, 0.0};
  double plain = 1.0;
  for (int i = 0; i < 1'000'000; ++i) {
    sum += 1e-17;
    plain += 1e-17;
  }
  EXPECT_EQ(plain, 1.0);
  EXPECT_NEAR((sum.value - 1.0) + sum.carry, 1e-11, 1e-20);
}

TEST(CompensatedSum, AgreesWithExtendedPrecision) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> term(-1.0, 1.0);
  CompensatedSum sum;
  long double exact = 0.0L;
  for (int i = 0; i < 100'000; ++i) {
    const double t = term(random) * (i % 7 == 0 ? 1e12 : 1.0);
    sum += t;
    exact += static_cast<long double>(t);
  }
  EXPECT_NEAR(sum.total(), static_cast<double>(exact), 1e-8);
}

TEST(CompensatedSum, TakesBackExactlyWhatWasAdded) {
  CompensatedSum sum{3.0, 0.0};
  const std::vector<double> terms{1e10, 1e-9, -7.25, 0.1, 1e-300, 12345.678};
  for (const double t : terms) {
    sum += t;
  }
  for (const double t : terms) {
    sum += -t;
  }
  EXPECT_EQ(sum.total(), 3.0);
}

}  // namespace
}  // namespace percolith
