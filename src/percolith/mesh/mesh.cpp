// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/mesh.hpp"

#include <cmath>

namespace percolith::mesh {

std::array<Point, 3> Mesh::triangle_points(Index triangle) const {
  std::array<Point, 3> points;
  for (std::size_t k = 0; k < 3; ++k) {
    points[k] =
        vertex[static_cast<std::size_t>(triangle_vertex[static_cast<std::size_t>(triangle)][k])];
  }
  return points;
}

Point Mesh::triangle_centre(Index triangle) const {
  const auto p = triangle_points(triangle);
  return (1.0 / 3.0) * (p[0] + p[1] + p[2]);
}

Point Mesh::middle_of(const std::array<Index, 2>& ends) const {
  return 0.5 *
         (vertex[static_cast<std::size_t>(ends[0])] + vertex[static_cast<std::size_t>(ends[1])]);
}

double Mesh::area(Index triangle) const {
  const auto p = triangle_points(triangle);
  return 0.5 * cross(p[1] - p[0], p[2] - p[0]);
}

double Mesh::joint_length(Index j) const {
  const auto& ends = joint[static_cast<std::size_t>(j)].vertex;
  const Point along =
      vertex[static_cast<std::size_t>(ends[1])] - vertex[static_cast<std::size_t>(ends[0])];
  return std::sqrt(dot(along, along));
}

Index Mesh::joint_end(Index j, Index v) const {
  return joint[static_cast<std::size_t>(j)].vertex[0] == v ? 0 : 1;
}

}  // namespace percolith::mesh
