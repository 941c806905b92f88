// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/gmsh_checks.hpp"

#include "percolith/mesh/gmsh_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace percolith::mesh {
namespace {

void require_index(const GmshMesh& mesh, std::int32_t index, std::size_t size, const char* what) {
  if (index < 0 || static_cast<std::size_t>(index) >= size) {
    fail_mesh({mesh.file}, fmt::format("{} {} does not exist; there are {}", what, index, size));
  }
}

double largest_coordinate(const GmshMesh& mesh) {
  double largest = 0.0;
  for (const Point& point : mesh.points) {
    largest = std::max({largest, std::abs(point.x), std::abs(point.y)});
  }
  return largest;
}

}  // namespace

void check_gmsh_mesh(const GmshMesh& mesh) {
  check_gmsh_indices(mesh);
  check_gmsh_coordinates(mesh);
  check_gmsh_areas(mesh);
  check_gmsh_duplicate_points(mesh);
  check_gmsh_edges(mesh);
}

void check_gmsh_indices(const GmshMesh& mesh) {
  if (mesh.triangles.empty()) {
    fail_mesh({mesh.file}, "the mesh has no triangles");
  }
  require_countable(mesh.points.size(), "points", {mesh.file});
  require_countable(mesh.triangles.size(), "triangles", {mesh.file});
  if (mesh.triangle_region.size() != mesh.triangles.size()) {
    fail_mesh({mesh.file}, fmt::format("{} triangles have {} regions", mesh.triangles.size(),
                                       mesh.triangle_region.size()));
  }
  const std::size_t points = mesh.points.size();
  for (const auto& triangle : mesh.triangles) {
    for (const std::int32_t point : triangle) {
      require_index(mesh, point, points, "point");
    }
  }
  for (const std::int32_t region : mesh.triangle_region) {
    require_index(mesh, region, mesh.regions.size(), "region");
  }
  for (const auto& [name, edges] : mesh.curves) {
    for (const auto& [a, b] : edges) {
      require_index(mesh, a, points, "point");
      require_index(mesh, b, points, "point");
    }
  }
  for (const auto& [name, group] : mesh.point_groups) {
    for (const std::int32_t point : group) {
      require_index(mesh, point, points, "point");
    }
  }
}

void check_gmsh_coordinates(const GmshMesh& mesh) {
  // Beyond this, areas and their products would overflow.
  constexpr double largest = 1e100;
  for (const Point& point : mesh.points) {
    if (!(std::abs(point.x) <= largest) || !(std::abs(point.y) <= largest)) {
      fail_mesh({mesh.file}, fmt::format("a point has the coordinates {}, which are not finite or "
                                         "too large",
                                         place_text(point)));
    }
  }
}

void check_gmsh_areas(const GmshMesh& mesh) {
  const double rounding = 8.0 * std::numeric_limits<double>::epsilon() * largest_coordinate(mesh);
  for (const auto& triangle : mesh.triangles) {
    const Point a = mesh.points[static_cast<std::size_t>(triangle[0])];
    const Point b = mesh.points[static_cast<std::size_t>(triangle[1])];
    const Point c = mesh.points[static_cast<std::size_t>(triangle[2])];
    const double longest_squared =
        std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)});
    const double twice_area = std::abs(cross(b - a, c - a));
    const double least = 1e-12 * longest_squared + rounding * std::sqrt(longest_squared);
    if (!(twice_area > least)) {
      fail_mesh({mesh.file},
                fmt::format("a triangle has no area: its corners are {}, {} and {}; mend the "
                            "geometry there and mesh again",
                            place_text(a), place_text(b), place_text(c)));
    }
  }
}

}  // namespace percolith::mesh
