// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/error.hpp"
#include "percolith/mesh/mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "unit/support/grid.hpp"
#include "unit/support/places.hpp"

namespace percolith::mesh {
namespace {

using test::at;

GmshMesh irregular(unsigned seed = 5) {
  return test::make_grid({.columns = 11,
                          .rows = 9,
                          .width = 3.0,
                          .height = 2.0,
                          .origin = {-1.0, 5.0},
                          .jitter = 0.3,
                          .seed = seed,
                          .mixed_diagonals = true});
}

TEST(Corner, SlotsOfATriangleAndBack) {
  std::set<Index> slots;
  for (Index t = 0; t < 37; ++t) {
    for (Index k = 0; k < 3; ++k) {
      const Index c = corner_of(t, k);
      EXPECT_EQ(triangle_of(c), t);
      EXPECT_EQ(local_of(c), k);
      EXPECT_LT(c, corner_slots(37));
      slots.insert(c);
    }
  }
  EXPECT_EQ(slots.size(), 3u * 37u);
  // The same corner of eight neighbours lies side by side.
  EXPECT_EQ(corner_of(9, 2), corner_of(8, 2) + 1);
}

TEST(BuildMesh, TrianglesRunCounterClockwiseAndFillTheRectangle) {
  const Mesh mesh = build_mesh(test::shuffled(irregular(), 4));
  double area = 0.0;
  for (Index t = 0; t < mesh.triangles(); ++t) {
    EXPECT_GT(mesh.area(t), 0.0);
    area += mesh.area(t);
  }
  EXPECT_NEAR(area, 6.0, 1e-13);
  // Euler: vertices - edges + triangles = 1 for a disc.
  const auto edges = mesh.joint.size() + mesh.boundary.size();
  EXPECT_EQ(static_cast<Index>(edges), mesh.vertices() + mesh.triangles() - 1);
  EXPECT_EQ(mesh.boundary.size(), 2u * (11u + 9u));
}

/// Everything geometric that does not depend on numbers: triangles by their sorted points.
std::multiset<std::multiset<std::pair<double, double>>> geometry(const Mesh& mesh) {
  std::multiset<std::multiset<std::pair<double, double>>> result;
  for (Index t = 0; t < mesh.triangles(); ++t) {
    std::multiset<std::pair<double, double>> points;
    for (const Point& p : mesh.triangle_points(t)) {
      points.insert({p.x, p.y});
    }
    result.insert(points);
  }
  return result;
}

TEST(BuildMesh, ClockwiseAndPermutedInputGivesTheSameGeometry) {
  const GmshMesh file = irregular();
  const Mesh reference = build_mesh(file);
  for (const unsigned seed : {1u, 2u, 3u}) {
    const Mesh mesh = build_mesh(test::shuffled(file, seed));
    EXPECT_EQ(geometry(mesh), geometry(reference));
    EXPECT_EQ(mesh.joints(), reference.joints());
    // Triangles follow the curve through space, so their order does not depend on the file either.
    for (Index t = 0; t < mesh.triangles(); ++t) {
      EXPECT_LT(test::distance(test::centroid(mesh, t), test::centroid(reference, t)), 1e-14);
    }
    for (const auto& [name, curve] : reference.curves) {
      EXPECT_EQ(mesh.curves.at(name).boundary.size(), curve.boundary.size());
    }
  }
}

TEST(BuildMesh, CornersOfAJointCoincideAndItsSidesAreOrdered) {
  const Mesh mesh = build_mesh(test::shuffled(irregular(), 8));
  std::set<std::pair<Index, Index>> seen;
  for (const Joint& joint : mesh.joint) {
    for (std::size_t end = 0; end < 2; ++end) {
      EXPECT_EQ(mesh.vertex_of(joint.corner[0][end]), joint.vertex[end]);
      EXPECT_EQ(mesh.vertex_of(joint.corner[1][end]), joint.vertex[end]);
    }
    const Index first = triangle_of(joint.corner[0][0]);
    const Index second = triangle_of(joint.corner[1][0]);
    EXPECT_EQ(triangle_of(joint.corner[0][1]), first);
    EXPECT_EQ(triangle_of(joint.corner[1][1]), second);
    EXPECT_LT(first, second);
    // Counter-clockwise round side 0: the first triangle lies to the left of the walk.
    const Point a = mesh.vertex[at(joint.vertex[0])];
    const Point along = mesh.vertex[at(joint.vertex[1])] - a;
    EXPECT_GT(cross(along, test::centroid(mesh, first) - a), 0.0);
    EXPECT_LT(cross(along, test::centroid(mesh, second) - a), 0.0);
    EXPECT_TRUE(seen.insert(std::minmax(joint.vertex[0], joint.vertex[1])).second);
  }
}

TEST(BuildMesh, BoundaryEdgesRunCounterClockwise) {
  const Mesh mesh = build_mesh(test::shuffled(irregular(), 9));
  double twice_area = 0.0;
  for (const BoundaryEdge& edge : mesh.boundary) {
    EXPECT_EQ(mesh.vertex_of(edge.corner[0]), edge.vertex[0]);
    EXPECT_EQ(mesh.vertex_of(edge.corner[1]), edge.vertex[1]);
    EXPECT_EQ(triangle_of(edge.corner[0]), triangle_of(edge.corner[1]));
    twice_area += cross(mesh.vertex[at(edge.vertex[0])], mesh.vertex[at(edge.vertex[1])]);
  }
  EXPECT_NEAR(twice_area, 12.0, 1e-12);
}

TEST(BuildMesh, FansAreCompleteAndAscending) {
  const Mesh mesh = build_mesh(test::shuffled(irregular(), 10));
  std::size_t corners = 0;
  std::size_t joints = 0;
  for (Index v = 0; v < mesh.vertices(); ++v) {
    const auto fan = mesh.vertex_corners.row(v);
    const auto ends = mesh.vertex_joints.row(v);
    EXPECT_TRUE(std::is_sorted(fan.begin(), fan.end()));
    EXPECT_TRUE(std::is_sorted(ends.begin(), ends.end()));
    for (const Index c : fan) {
      EXPECT_EQ(mesh.vertex_of(c), v);
    }
    for (const Index j : ends) {
      EXPECT_EQ(mesh.joint[at(j)].vertex[at(mesh.joint_end(j, v))], v);
    }
    corners += fan.size();
    joints += ends.size();
  }
  EXPECT_EQ(corners, 3 * mesh.triangle_vertex.size());
  EXPECT_EQ(joints, 2 * mesh.joint.size());
}

TEST(BuildMesh, CurvesBecomeJointsBoundaryEdgesAndLooseEdges) {
  const test::Grid grid{.columns = 4, .rows = 4};
  GmshMesh file = test::make_grid(grid);
  test::add_column_curve(grid, file, "crack", 2, 1, 3);
  test::add_column_curve(grid, file, "crack", 2, 1, 2);  // named twice
  file.curves["mixed"] = {{grid.point(0, 0), grid.point(0, 1)},
                          {grid.point(1, 1), grid.point(1, 2)},
                          {grid.point(0, 4), grid.point(4, 0)}};
  file.point_groups["well"] = {grid.point(2, 2), grid.point(2, 2)};
  const Mesh mesh = build_mesh(test::shuffled(file, 2));
  EXPECT_EQ(mesh.curves.at("left").boundary.size(), 4u);
  EXPECT_TRUE(mesh.curves.at("left").joints.empty());
  const CurveEdges& crack = mesh.curves.at("crack");
  ASSERT_EQ(crack.joints.size(), 2u);
  EXPECT_TRUE(std::is_sorted(crack.joints.begin(), crack.joints.end()));
  for (const Index j : crack.joints) {
    EXPECT_NEAR(mesh.joint_length(j), 0.25, 1e-15);
    for (const Index v : mesh.joint[at(j)].vertex) {
      EXPECT_NEAR(mesh.vertex[at(v)].x, 0.5, 1e-15);
    }
  }
  const CurveEdges& mixed = mesh.curves.at("mixed");
  EXPECT_EQ(mixed.joints.size(), 1u);
  EXPECT_EQ(mixed.boundary.size(), 1u);
  EXPECT_EQ(mixed.loose.size(), 1u);
  ASSERT_EQ(mesh.point_groups.at("well").size(), 1u);
  EXPECT_EQ(mesh.vertex[at(mesh.point_groups.at("well")[0])], (Point{0.5, 0.5}));
}

TEST(BuildMesh, RegionsStayWithTheirTriangles) {
  GmshMesh file = test::make_grid({.columns = 6, .rows = 6});
  file.regions = {"lower", "upper"};
  for (std::size_t t = 0; t < file.triangles.size(); ++t) {
    file.triangle_region[t] = t < file.triangles.size() / 2 ? 0 : 1;
  }
  const Mesh mesh = build_mesh(test::shuffled(file, 6));
  for (Index t = 0; t < mesh.triangles(); ++t) {
    EXPECT_EQ(mesh.region[at(t)], test::centroid(mesh, t).y < 0.5 ? 0 : 1);
  }
}

TEST(BuildMesh, RefusesAnEdgeOfThreeTriangles) {
  GmshMesh file;
  file.file = "fold.msh";
  file.regions = {"rock"};
  file.points = {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {0.5, -1}};
  file.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  file.triangle_region = {0, 0, 0};
  try {
    (void)build_mesh(file);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problem().key, "mesh.file");
    EXPECT_NE(std::string(error.what()).find("fold.msh: error: mesh.file: an edge at ("),
              std::string::npos)
        << error.what();
    EXPECT_NE(std::string(error.what()).find("belongs to more than two triangles"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace percolith::mesh
