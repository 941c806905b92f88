// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/ordering.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace percolith::mesh {
namespace {

std::vector<Point> lattice(int n, Point origin, double spacing) {
  std::vector<Point> points;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      points.push_back({origin.x + spacing * i, origin.y + spacing * j});
    }
  }
  return points;
}

TEST(HilbertOrder, VisitsNeighbourAfterNeighbourOfALattice) {
  for (const Point origin : {Point{0.0, 0.0}, Point{-700.0, 1e6}}) {
    auto points = lattice(32, origin, 2.0);
    std::shuffle(points.begin(), points.end(), std::mt19937(1));
    const std::vector<Index> order = hilbert_order(points);
    auto sorted = order;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      ASSERT_EQ(sorted[i], static_cast<Index>(i));
    }
    for (std::size_t i = 1; i < order.size(); ++i) {
      const Point step = points[static_cast<std::size_t>(order[i])] -
                         points[static_cast<std::size_t>(order[i - 1])];
      // The curve never leaves a cell but to one that touches it.
      ASSERT_NEAR(std::abs(step.x) + std::abs(step.y), 2.0, 1e-9);
    }
  }
}

TEST(HilbertOrder, CoincidentPointsKeepTheirOrder) {
  const std::vector<Point> points(5, Point{3.0, 4.0});
  EXPECT_EQ(hilbert_order(points), (std::vector<Index>{0, 1, 2, 3, 4}));
  EXPECT_TRUE(hilbert_order({}).empty());
}

}  // namespace
}  // namespace percolith::mesh
