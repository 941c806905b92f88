// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/contact/overlap.hpp"

namespace percolith::mechanics {
namespace {

/// The part of a polygon where a linear function, given at its corners, is not negative.
Polygon keep(const Polygon& polygon, const std::array<double, Polygon::most>& value) {
  Polygon kept;
  for (std::size_t k = 0; k < polygon.corners; ++k) {
    const std::size_t last = k + 1 == polygon.corners ? 0 : k + 1;
    if (value[k] >= 0.0) {
      kept.add(polygon.corner[k]);
    }
    if ((value[k] > 0.0 && value[last] < 0.0) || (value[k] < 0.0 && value[last] > 0.0)) {
      const double share = value[k] / (value[k] - value[last]);
      kept.add(polygon.corner[k] + share * (polygon.corner[last] - polygon.corner[k]));
    }
  }
  return kept;
}

/// Area coordinate `i` of a point, times twice the area of the triangle.
double coordinate(const Corners& triangle, std::size_t i, const Point& p) {
  return beside_edge(triangle, (i + 1) % 3, p);
}

}  // namespace

Polygon overlap_of(const Corners& first, const Corners& second) {
  Polygon polygon;
  for (const Point& p : first) {
    polygon.add(p);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<double, Polygon::most> value{};
    for (std::size_t k = 0; k < polygon.corners; ++k) {
      value[k] = beside_edge(second, i, polygon.corner[k]);
    }
    polygon = keep(polygon, value);
  }
  return polygon;
}

double area_of(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t k = 2; k < polygon.corners; ++k) {
    twice +=
        cross(polygon.corner[k - 1] - polygon.corner[0], polygon.corner[k] - polygon.corner[0]);
  }
  return 0.5 * twice;
}

double potential_over(const Polygon& polygon, const Corners& triangle) {
  const double whole = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    // Where coordinate i is the smallest of the three, phi is linear.
    Polygon piece = polygon;
    for (std::size_t other = 1; other < 3; ++other) {
      std::array<double, Polygon::most> value{};
      for (std::size_t k = 0; k < piece.corners; ++k) {
        value[k] = coordinate(triangle, (i + other) % 3, piece.corner[k]) -
                   coordinate(triangle, i, piece.corner[k]);
      }
      piece = keep(piece, value);
    }
    for (std::size_t k = 2; k < piece.corners; ++k) {
      const Corners part{piece.corner[0], piece.corner[k - 1], piece.corner[k]};
      double mean = 0.0;
      for (const Point& p : part) {
        mean += coordinate(triangle, i, p) / (3.0 * whole);
      }
      sum += 3.0 * mean * 0.5 * cross(part[1] - part[0], part[2] - part[0]);
    }
  }
  return sum;
}

}  // namespace percolith::mechanics
