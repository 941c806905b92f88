// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/mesh_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace percolith::simulation {
namespace {

using mesh::Index;

double angle_at(const std::array<Point, 3>& p, std::size_t k) {
  const Point a = p[(k + 1) % 3] - p[k];
  const Point b = p[(k + 2) % 3] - p[k];
  return std::atan2(cross(a, b), dot(a, b)) * 180.0 / std::numbers::pi;
}

}  // namespace

void describe_mesh(const mesh::Mesh& mesh, CheckReport& report) {
  report.triangles = mesh.triangles();
  report.vertices = mesh.vertices();
  report.joints = mesh.joints();
  report.boundary_edges = static_cast<std::int64_t>(mesh.boundary.size());
  constexpr double infinity = std::numeric_limits<double>::infinity();
  report.lower_corner = {infinity, infinity};
  report.upper_corner = {-infinity, -infinity};
  for (const Point& p : mesh.vertex) {
    report.lower_corner = {std::min(report.lower_corner.x, p.x),
                           std::min(report.lower_corner.y, p.y)};
    report.upper_corner = {std::max(report.upper_corner.x, p.x),
                           std::max(report.upper_corner.y, p.y)};
  }
  report.smallest_angle = 180.0;
  report.smallest_edge = infinity;
  for (Index t = 0; t < mesh.triangles(); ++t) {
    const auto p = mesh.triangle_points(t);
    report.area += mesh.area(t);
    report.region_area[mesh.region_names[at(mesh.region[at(t)])]] += mesh.area(t);
    for (std::size_t k = 0; k < 3; ++k) {
      const Point edge = p[(k + 1) % 3] - p[k];
      const double length = std::sqrt(dot(edge, edge));
      report.smallest_edge = std::min(report.smallest_edge, length);
      report.largest_edge = std::max(report.largest_edge, length);
      const double angle = angle_at(p, k);
      report.largest_angle = std::max(report.largest_angle, angle);
      if (angle < report.smallest_angle) {
        report.smallest_angle = angle;
        report.smallest_angle_place = p[k];
      }
    }
  }
  if (report.smallest_angle < 10.0) {
    report.warnings.push_back(fmt::format(
        "the smallest angle of the mesh is {:.1f} degree, at ({:g}, {:g}): gradients "
        "are poor there",
        report.smallest_angle, report.smallest_angle_place.x, report.smallest_angle_place.y));
  }
}

}  // namespace percolith::simulation
