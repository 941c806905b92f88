// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/vec2.hpp"

#include <array>

namespace percolith::mechanics {

using Corners = std::array<Point, 3>;

/// A triangle where it is now, in one cache line. Place and displacement are kept apart, so that
/// what lies between two triangles keeps its digits far from the origin.
struct alignas(64) PlacedTriangle {
  Point origin;  ///< m, corner 0 before any motion
  Point shift;   ///< m, displacement of corner 0
  Point leg_1;   ///< m, from corner 0 to corner 1 now
  Point leg_2;   ///< m, from corner 0 to corner 2 now
};

/// Twice the area, m2; not positive where the triangle is degenerate or inverted.
inline double twice_area(const PlacedTriangle& t) {
  return cross(t.leg_1, t.leg_2);
}

/// The corners of two triangles as seen from corner 0 of the first, m.
template <class Real>
struct PairPlaces {
  std::array<Vec2<Real>, 3> first, second;
};
using PlacedPair = PairPlaces<double>;

inline PlacedPair place_pair(const PlacedTriangle& a, const PlacedTriangle& b) {
  const Point between = (b.origin - a.origin) + (b.shift - a.shift);
  return {{Point{}, a.leg_1, a.leg_2}, {between, between + b.leg_1, between + b.leg_2}};
}

/// Twice the area, m2; not positive where the triangle is degenerate or inverted.
template <class Real>
PERCOLITH_DEVICE Real twice_area(const std::array<Vec2<Real>, 3>& triangle) {
  return cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
}

/// The corner that follows corner `k`.
PERCOLITH_DEVICE std::size_t next_corner(std::size_t k) {
  return k == 2 ? 0 : k + 1;
}

/// Twice the signed area between edge `i` (from corner i to the next) and a point, m2: positive on
/// the inner side.
template <class Real>
PERCOLITH_DEVICE Real beside_edge(const std::array<Vec2<Real>, 3>& triangle, std::size_t i,
                                  const Vec2<Real>& p) {
  const Vec2<Real> start = triangle[i];
  return cross(triangle[next_corner(i)] - start, p - start);
}

}  // namespace percolith::mechanics
