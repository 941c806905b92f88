// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/tensor2.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace percolith {
namespace {

TEST(Vec2, ClockwiseOfACounterClockwiseEdgePointsOutward) {
  // The lower edge of a triangle above it runs to the right; outward is down.
  EXPECT_EQ(clockwise(Point{1.0, 0.0}), (Point{0.0, -1.0}));
  EXPECT_EQ(clockwise(Point{0.0, 1.0}), (Point{1.0, 0.0}));
}

TEST(Vec2, CrossIsTheSignedParallelogram) {
  EXPECT_EQ(cross(Point{2.0, 0.0}, Point{0.0, 3.0}), 6.0);
  EXPECT_EQ(cross(Point{0.0, 3.0}, Point{2.0, 0.0}), -6.0);
  EXPECT_EQ(dot(Point{2.0, 5.0}, Point{-1.0, 3.0}), 13.0);
}

TEST(Tensor, MultipliesAsASymmetricMatrix) {
  const Tensor a{2.0, 5.0, -1.0};
  EXPECT_EQ((a * Point{3.0, 4.0}), (Point{2.0 * 3.0 - 4.0, -3.0 + 5.0 * 4.0}));
}

TEST(Tensor, IsPositiveDefiniteWhenBothPrincipalValuesAre) {
  // Principal values p and q turned by an angle.
  const auto turned = [](double p, double q, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return Tensor{p * c * c + q * s * s, p * s * s + q * c * c, (p - q) * c * s};
  };
  for (double angle = 0.0; angle < 3.2; angle += 0.3) {
    EXPECT_TRUE(is_positive_definite(turned(1.0, 1e-6, angle))) << angle;
    EXPECT_FALSE(is_positive_definite(turned(1.0, -1e-6, angle))) << angle;
    EXPECT_FALSE(is_positive_definite(turned(-1.0, -2.0, angle))) << angle;
  }
  EXPECT_FALSE(is_positive_definite({1.0, 1.0, 1.0}));
}

}  // namespace
}  // namespace percolith
