// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/contact/placed_triangle.hpp"

#include <array>
#include <cstddef>

namespace percolith::mechanics {

/// A convex polygon, counter-clockwise. Two triangles overlap in six corners at most and dividing
/// that at two lines adds two; rounding may repeat a few.
struct Polygon {
  static constexpr std::size_t most = 12;
  std::array<Point, most> corner{};
  std::size_t corners = 0;
  /// Past the room there is only what rounding repeats.
  void add(const Point& p) {
    if (corners < most) {
      corner[corners++] = p;
    }
  }
};

/// The overlap of two triangles (counter-clockwise), by clipping the first at the edges of the
/// second.
[[nodiscard]] Polygon overlap_of(const Corners& first, const Corners& second);

/// m2
[[nodiscard]] double area_of(const Polygon& polygon);

/// Integral of the potential (5) of a triangle over a polygon within it, m2.
[[nodiscard]] double potential_over(const Polygon& polygon, const Corners& triangle);

}  // namespace percolith::mechanics
