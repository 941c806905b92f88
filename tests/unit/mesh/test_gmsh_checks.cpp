// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/gmsh_checks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "unit/mesh/test_gmsh_samples.hpp"

namespace percolith::mesh {
namespace {

using samples::message_of;

/// The unit square, cut along the diagonal from (0, 0).
GmshMesh square() {
  GmshMesh mesh;
  mesh.file = "m.msh";
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.triangle_region = {0, 0};
  mesh.regions = {"rock"};
  mesh.curves["left"] = {{0, 3}};
  return mesh;
}

std::string problem(const GmshMesh& mesh) {
  const std::string message = message_of([&] { check_gmsh_mesh(mesh); });
  const std::string common = "m.msh: error: mesh.file: ";
  return message.starts_with(common) ? message.substr(common.size()) : message;
}

TEST(GmshChecks, PassesASoundMeshOfMixedOrientation) {
  GmshMesh mesh = square();
  EXPECT_EQ(problem(mesh), "no error");
  mesh.triangles[1] = {0, 3, 2};
  EXPECT_EQ(problem(mesh), "no error");
}

TEST(GmshChecks, FindsIndicesOutOfRange) {
  GmshMesh mesh = square();
  mesh.triangles[1][2] = 4;
  EXPECT_EQ(problem(mesh), "point 4 does not exist; there are 4");
  mesh = square();
  mesh.triangle_region[1] = -1;
  EXPECT_EQ(problem(mesh), "region -1 does not exist; there are 1");
  mesh = square();
  mesh.triangle_region.pop_back();
  EXPECT_EQ(problem(mesh), "2 triangles have 1 regions");
  mesh = square();
  mesh.curves["left"] = {{0, 9}};
  EXPECT_EQ(problem(mesh), "point 9 does not exist; there are 4");
  mesh = square();
  mesh.point_groups["well"] = {-7};
  EXPECT_EQ(problem(mesh), "point -7 does not exist; there are 4");
  mesh.triangles.clear();
  EXPECT_EQ(problem(mesh), "the mesh has no triangles");
}

TEST(GmshChecks, FindsCoordinatesThatAreNotFinite) {
  GmshMesh mesh = square();
  mesh.points[2].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(problem(mesh), "a point has the coordinates (nan, 1), which are not finite or too "
                           "large");
  mesh.points[2].x = 1e200;
  EXPECT_EQ(problem(mesh), "a point has the coordinates (1e+200, 1), which are not finite or too "
                           "large");
}

TEST(GmshChecks, FindsTrianglesWithoutArea) {
  GmshMesh mesh = square();
  mesh.points[1] = {0.5, 0.5};
  EXPECT_EQ(problem(mesh), "a triangle has no area: its corners are (0, 0), (0.5, 0.5) and (1, 1); "
                           "mend the geometry there and mesh again");
  // Far from the origin, corners on a line are so only to rounding.
  mesh = square();
  mesh.points = {{1e6, 1e6}, {1e6 + 0.1, 1e6 + 0.3}, {1e6 + 0.2, 1e6 + 0.6}, {1e6, 1e6 + 1}};
  EXPECT_TRUE(problem(mesh).starts_with("a triangle has no area: its corners are (1000000, "
                                        "1000000), (1000000.1, 1000000.3) and"))
      << problem(mesh);
  mesh.points[1] = {1e6 + 0.1, 1e6 + 0.2999};
  EXPECT_EQ(problem(mesh), "no error");
}

TEST(GmshChecks, FindsTrianglesListedTwice) {
  GmshMesh mesh = square();
  mesh.triangles.push_back({3, 2, 0});
  mesh.triangle_region.push_back(0);
  EXPECT_EQ(problem(mesh), "the triangle at (0.333333333, 0.666666667) is listed twice; surfaces "
                           "must not overlap");
  mesh.regions.push_back("clay");
  mesh.triangle_region.back() = 1;
  EXPECT_EQ(problem(mesh), "region assigned twice: the triangle at (0.333333333, 0.666666667) is "
                           "in the physical surfaces 'rock' and 'clay'; keep one");
}

TEST(GmshChecks, FindsEdgesOfThreeTriangles) {
  GmshMesh mesh = square();
  mesh.points.push_back({3, 1});
  mesh.triangles.push_back({0, 2, 4});
  mesh.triangle_region.push_back(0);
  EXPECT_EQ(problem(mesh), "the edge at (0.5, 0.5) belongs to 3 triangles; surfaces must not "
                           "overlap; allowed: one or two triangles at an edge");
}

TEST(GmshChecks, FindsInvertedTriangles) {
  GmshMesh mesh = square();
  mesh.points[3] = {0.9, 0.2};
  EXPECT_EQ(problem(mesh), "the two triangles at the edge at (0.5, 0.5) lie on the same side of "
                           "it: one is inverted (folded over); mend the geometry there or mesh "
                           "finer");
}

TEST(GmshChecks, FindsCurveEdgesThatAreNoEdgesOfTriangles) {
  GmshMesh mesh = square();
  mesh.curves["fault"] = {{0, 2}, {1, 3}};
  EXPECT_EQ(problem(mesh), "an edge of physical curve 'fault' at (0.5, 0.5) is not an edge of a "
                           "triangle; embed the curve with 'Curve{...} In Surface{...};' and mesh "
                           "again");
}

/// Two unit squares side by side, each with points of its own on the common side.
GmshMesh unjoined_squares(double gap) {
  GmshMesh mesh = square();
  mesh.points.insert(mesh.points.end(), {{1 + gap, 0}, {2, 0}, {2, 1}, {1 + gap, 1}});
  mesh.triangles.insert(mesh.triangles.end(), {{4, 5, 6}, {4, 6, 7}});
  mesh.triangle_region.insert(mesh.triangle_region.end(), {0, 0});
  return mesh;
}

TEST(GmshChecks, FindsTwoPointsAtOnePlace) {
  const std::string reason =
      ", so the triangles there are not connected; write 'Coherence;' at the end of the geometry, "
      "or join them with 'Coherence Mesh;' (RemoveDuplicateNodes), and mesh again";
  const std::string begin = "two points of the mesh lie at ";
  EXPECT_EQ(problem(unjoined_squares(0.0)), begin + "(1, 0)" + reason);
  EXPECT_EQ(problem(unjoined_squares(1e-8)), begin + "(1.00000001, 0)" + reason);
  EXPECT_EQ(problem(unjoined_squares(-1e-8)), begin + "(0.99999999, 0)" + reason);
  EXPECT_EQ(problem(unjoined_squares(1e-6)), "no error");
}

TEST(GmshChecks, FindsTwoPointsAtOnePlaceBeforeTheCurveBetweenThem) {
  GmshMesh mesh = unjoined_squares(0.0);
  mesh.curves["fault"] = {{1, 7}};
  const std::string found = problem(mesh);
  EXPECT_EQ(found.rfind("two points of the mesh lie at (1, 0), so the triangles there", 0), 0U)
      << found;
  mesh = unjoined_squares(0.5);
  mesh.curves["fault"] = {{1, 7}};
  EXPECT_EQ(problem(mesh).rfind("an edge of physical curve 'fault' at (1.25, 0.5)", 0), 0U);
}

/// The answer of the hash table compared with that of all pairs, for points on both sides of the
/// tolerance in every direction.
TEST(GmshChecks, FindsClosePointsInEveryDirection) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int found = 0;
  for (int round = 0; round < 2000; ++round) {
    GmshMesh mesh = unjoined_squares(0.1);
    const Point shift{1.6e-8 * uniform(random) * 2.0, 1.6e-8 * uniform(random) * 2.0};
    mesh.points[1] = {uniform(random) * 0.1 + 0.8, -0.2 + 0.1 * uniform(random)};
    mesh.points[4] = mesh.points[1] + shift;
    const double width = 2.0;
    const double height = 1.0 - std::min(mesh.points[1].y, mesh.points[4].y);
    const double tolerance = 1e-8 * std::max(width, height);
    const Point distance = mesh.points[4] - mesh.points[1];
    const bool close = std::max(std::abs(distance.x), std::abs(distance.y)) < tolerance;
    const bool reported = message_of([&] {
                            check_gmsh_duplicate_points(mesh);
                          }).find("two points") != std::string::npos;
    EXPECT_EQ(reported, close) << shift.x << " " << shift.y;
    found += reported ? 1 : 0;
  }
  EXPECT_GT(found, 400);
  EXPECT_LT(found, 1600);
}

}  // namespace
}  // namespace percolith::mesh
