// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/triangle_finder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "unit/support/grid.hpp"
#include "unit/support/places.hpp"

namespace percolith::mesh {
namespace {

using test::at;

Point place_of(const Mesh& mesh, const PlaceInTriangle& place) {
  const auto p = mesh.triangle_points(place.triangle);
  return place.weight[0] * p[0] + place.weight[1] * p[1] + place.weight[2] * p[2];
}

TEST(TriangleFinder, FindsEveryPointOfTheRockWithItsWeights) {
  for (const Point origin : {Point{-2.0, 1.0}, Point{4e5, -1e3}}) {
    const Mesh mesh = build_mesh(test::make_grid({.columns = 40,
                                                  .rows = 3,
                                                  .width = 8.0,
                                                  .height = 0.5,
                                                  .origin = origin,
                                                  .jitter = 0.3,
                                                  .mixed_diagonals = true}));
    const TriangleFinder finder(mesh);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> x(origin.x, origin.x + 8.0);
    std::uniform_real_distribution<double> y(origin.y, origin.y + 0.5);
    for (int i = 0; i < 2000; ++i) {
      const Point p{x(random), y(random)};
      const auto place = finder.find(p);
      ASSERT_TRUE(place);
      double sum = 0.0;
      for (const double w : place->weight) {
        EXPECT_GE(w, 0.0);
        sum += w;
      }
      EXPECT_NEAR(sum, 1.0, 1e-14);
      EXPECT_LT(test::distance(place_of(mesh, *place), p), 1e-9);
    }
  }
}

TEST(TriangleFinder, AVertexBelongsToItsFirstTriangle) {
  const Mesh mesh = build_mesh(test::make_grid({.columns = 6, .rows = 6, .jitter = 0.2}));
  const TriangleFinder finder(mesh);
  for (Index v = 0; v < mesh.vertices(); ++v) {
    const auto place = finder.find(mesh.vertex[at(v)]);
    ASSERT_TRUE(place);
    Index lowest = mesh.triangles();
    for (const Index c : mesh.vertex_corners.row(v)) {
      lowest = std::min(lowest, triangle_of(c));
    }
    EXPECT_EQ(place->triangle, lowest);
    for (Index k = 0; k < 3; ++k) {
      const bool here = mesh.vertex_of(corner_of(place->triangle, k)) == v;
      EXPECT_NEAR(place->weight[at(k)], here ? 1.0 : 0.0, 1e-12);
    }
  }
}

TEST(TriangleFinder, FindsNothingOutside) {
  const Mesh mesh = build_mesh(test::make_grid({.columns = 6, .rows = 6}));
  const TriangleFinder finder(mesh);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Point p : {Point{-1e-6, 0.5}, Point{1.0 + 1e-6, 0.5}, Point{0.5, -3.0},
                        Point{1e300, 1e300}, Point{std::nan(""), 0.5}, Point{0.5, infinity}}) {
    EXPECT_FALSE(finder.find(p)) << p.x << ' ' << p.y;
  }
  EXPECT_TRUE(finder.find({1.0, 1.0}));
}

}  // namespace
}  // namespace percolith::mesh
