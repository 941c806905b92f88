// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/ordering.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

namespace percolith::mesh {
namespace {

constexpr std::uint32_t cells = 1U << 16U;

/// Distance along the Hilbert curve of a grid cell, by descending through its quadrants.
std::uint64_t hilbert_distance(std::uint32_t x, std::uint32_t y) {
  std::uint64_t distance = 0;
  for (std::uint32_t side = cells / 2; side > 0; side /= 2) {
    const std::uint32_t right = (x & side) != 0 ? 1 : 0;
    const std::uint32_t upper = (y & side) != 0 ? 1 : 0;
    distance += std::uint64_t{side} * side * ((3 * right) ^ upper);
    if (upper == 0) {
      if (right == 1) {
        x = cells - 1 - x;
        y = cells - 1 - y;
      }
      std::swap(x, y);
    }
  }
  return distance;
}

}  // namespace

std::vector<Index> hilbert_order(std::span<const Point> points) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Point low{infinity, infinity};
  Point high{-infinity, -infinity};
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double extent = std::max({high.x - low.x, high.y - low.y, 1e-300});
  const auto cell = [&](double offset) {
    return static_cast<std::uint32_t>(std::min(offset / extent * cells, cells - 1.0));
  };
  std::vector<std::pair<std::uint64_t, Index>> key(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    key[i] = {hilbert_distance(cell(points[i].x - low.x), cell(points[i].y - low.y)),
              static_cast<Index>(i)};
  }
  std::sort(key.begin(), key.end());
  std::vector<Index> order(points.size());
  std::transform(key.begin(), key.end(), order.begin(), [](const auto& k) { return k.second; });
  return order;
}

}  // namespace percolith::mesh
