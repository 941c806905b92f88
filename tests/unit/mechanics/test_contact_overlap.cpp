// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "unit/mechanics/test_contact_support.hpp"

namespace percolith::mechanics {
namespace {

using test::placed;

bool contains(const Corners& t, const Point& p) {
  return beside_edge(t, 0, p) >= 0.0 && beside_edge(t, 1, p) >= 0.0 && beside_edge(t, 2, p) >= 0.0;
}

/// Area of the overlap by another way: corners of one within the other, crossings of edges, sorted
/// by their angle round the middle.
double area_by_angles(const Corners& a, const Corners& b) {
  std::vector<Point> points;
  for (std::size_t k = 0; k < 3; ++k) {
    if (contains(b, a[k])) {
      points.push_back(a[k]);
    }
    if (contains(a, b[k])) {
      points.push_back(b[k]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const Point first = a[(k + 1) % 3] - a[k];
      const Point second = b[(i + 1) % 3] - b[i];
      const double s = cross(b[i] - a[k], second) / cross(first, second);
      const double t = cross(b[i] - a[k], first) / cross(first, second);
      if (s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0) {
        points.push_back(a[k] + s * first);
      }
    }
  }
  Point middle;
  for (const Point& p : points) {
    middle = middle + (1.0 / static_cast<double>(points.size())) * p;
  }
  std::sort(points.begin(), points.end(), [&](const Point& p, const Point& q) {
    return std::atan2(p.y - middle.y, p.x - middle.x) < std::atan2(q.y - middle.y, q.x - middle.x);
  });
  double area = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    area += 0.5 * cross(points[k] - middle, points[(k + 1) % points.size()] - middle);
  }
  return area;
}

constexpr double penalty = 2e9;

/// Energy of a pair whose undeformed triangles are given.
double energy(const Corners& a, const Corners& b, const Corners& a0, const Corners& b0) {
  const Polygon overlap = overlap_of(a, b);
  const auto ratio = [](const Corners& before, const Corners& now) {
    return twice_area(placed(before)) / twice_area(placed(now));
  };
  return penalty *
         (ratio(a0, a) * potential_over(overlap, a) + ratio(b0, b) * potential_over(overlap, b));
}

OverlapForce force(const Corners& a, const Corners& b) {
  return overlap_force(place_pair(placed(a), placed(b)), {penalty, penalty});
}

TEST(ContactOverlap, AreaAgreesWithSortedCrossings) {
  std::mt19937 random(7);
  int overlapping = 0;
  for (int i = 0; i < 2000; ++i) {
    const Corners a = test::random_triangle(random);
    const Corners b = test::random_triangle(random, {0.3, 0.2});
    const double area = area_by_angles(a, b);
    EXPECT_NEAR(area_of(overlap_of(a, b)), area, 1e-14);
    EXPECT_EQ(separated(pair_sides(place_pair(placed(a), placed(b)))), area == 0.0);
    overlapping += area > 0.0 ? 1 : 0;
  }
  EXPECT_GT(overlapping, 1000);
}

TEST(ContactOverlap, PotentialOfAWholeTriangleIsAThirdOfItsArea) {
  std::mt19937 random(3);
  const Corners t = test::random_triangle(random);
  EXPECT_NEAR(potential_over(overlap_of(t, t), t), area_of(overlap_of(t, t)) / 3.0, 1e-15);
}

TEST(ContactOverlap, TheForceOfEachCornerIsTheDerivativeOfTheEnergy) {
  std::mt19937 random(11);
  for (int i = 0; i < 200; ++i) {
    const std::array<Corners, 2> rest{test::random_triangle(random),
                                      test::random_triangle(random, {0.2, 0.1})};
    const OverlapForce f = force(rest[0], rest[1]);
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t k = 0; k < 3; ++k) {
        for (const Point direction : {Point{1.0, 0.0}, Point{0.0, 1.0}}) {
          const double step = 1e-6;
          std::array<double, 2> e{};
          for (std::size_t s = 0; s < 2; ++s) {
            auto moved = rest;
            moved[side][k] = moved[side][k] + (s == 0 ? step : -step) * direction;
            e[s] = energy(moved[0], moved[1], rest[0], rest[1]);
          }
          EXPECT_NEAR(dot(f.on[side][k], direction), -(e[0] - e[1]) / (2.0 * step), 2e-5 * penalty);
        }
      }
    }
  }
}

TEST(ContactOverlap, MomentumAndAngularMomentumAreKept) {
  std::mt19937 random(5);
  for (int i = 0; i < 500; ++i) {
    const std::array<Corners, 2> t{test::random_triangle(random),
                                   test::random_triangle(random, {0.3, 0.0})};
    const OverlapForce f = force(t[0], t[1]);
    Point sum;
    double torque = 0.0;
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t k = 0; k < 3; ++k) {
        sum = sum + f.on[side][k];
        torque += cross(t[side][k], f.on[side][k]);
      }
    }
    EXPECT_NEAR(sum.x, 0.0, 1e-14 * penalty);
    EXPECT_NEAR(sum.y, 0.0, 1e-14 * penalty);
    EXPECT_NEAR(torque, 0.0, 1e-14 * penalty);
  }
}

TEST(ContactOverlap, IsTheSameWhenExchangedAndTurnsWithThePair) {
  std::mt19937 random(9);
  const double angle = 0.7;
  const auto turned = [&](const Point& p) {
    return Point{std::cos(angle) * p.x - std::sin(angle) * p.y,
                 std::sin(angle) * p.x + std::cos(angle) * p.y};
  };
  for (int i = 0; i < 100; ++i) {
    const Corners a = test::random_triangle(random);
    const Corners b = test::random_triangle(random, {0.3, 0.1});
    const OverlapForce f = force(a, b);
    const OverlapForce exchanged = force(b, a);
    const OverlapForce rotated = force({turned(a[0]), turned(a[1]), turned(a[2])},
                                       {turned(b[0]), turned(b[1]), turned(b[2])});
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(f.on[0][k].x, exchanged.on[1][k].x, 1e-13 * penalty);
      EXPECT_NEAR(f.on[1][k].y, exchanged.on[0][k].y, 1e-13 * penalty);
      EXPECT_NEAR(turned(f.on[0][k]).x, rotated.on[0][k].x, 1e-13 * penalty);
      EXPECT_NEAR(turned(f.on[1][k]).y, rotated.on[1][k].y, 1e-13 * penalty);
    }
  }
}

TEST(ContactOverlap, PushesTheTrianglesApart) {
  Corners top = test::pointed;
  for (Point& p : top) {
    p.y -= 0.05;
  }
  const OverlapForce f = force(top, test::floor_triangle);
  EXPECT_GT(f.total.y, 0.0);
  EXPECT_NEAR(f.total.x, 0.0, 1e-12 * f.total.y);
  EXPECT_NEAR(extent_along(f, {0.0, 1.0}), 0.05, 1e-15);
  // The width of the tip where it enters: 0.05 / 0.8 of its upper edge.
  EXPECT_NEAR(extent_along(f, {1.0, 0.0}), 0.0625, 1e-15);
}

TEST(ContactOverlap, AThinOverlapIsAsExactAKilometreAway) {
  const Point away{1024.0, -2048.0};
  const double depth = 1e-9;
  PlacedTriangle near_top = placed(test::flat);
  PlacedTriangle near_floor = placed(test::floor_triangle);
  near_top.shift.y = -depth;
  PlacedTriangle top = near_top;
  PlacedTriangle ground = near_floor;
  top.origin = top.origin + away;
  ground.origin = ground.origin + away;
  const OverlapForce here = overlap_force(place_pair(near_top, near_floor), {penalty, penalty});
  const OverlapForce there = overlap_force(place_pair(top, ground), {penalty, penalty});
  EXPECT_GT(here.total.y, 0.0);
  EXPECT_DOUBLE_EQ(here.total.y, there.total.y);
}

TEST(ContactOverlap, SharedSidesThatOnlyTouchGiveNoForce) {
  const OverlapForce f = force(test::flat, test::floor_triangle);
  EXPECT_EQ(f.total, (Point{0.0, 0.0}));
  const PlacedPair pair = place_pair(placed(test::flat), placed(test::floor_triangle));
  EXPECT_TRUE(separated(pair_sides(pair)));
}

}  // namespace
}  // namespace percolith::mechanics
