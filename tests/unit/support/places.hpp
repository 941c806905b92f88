// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/mesh.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

// Finding things in a built mesh by where they are.
namespace percolith::test {

inline std::size_t at(mesh::Index i) {
  return static_cast<std::size_t>(i);
}

inline double distance(Point a, Point b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// The vertex nearest to a place.
inline mesh::Index vertex_at(const mesh::Mesh& mesh, Point place) {
  mesh::Index best = 0;
  for (mesh::Index v = 1; v < mesh.vertices(); ++v) {
    if (distance(mesh.vertex[at(v)], place) < distance(mesh.vertex[at(best)], place)) {
      best = v;
    }
  }
  return best;
}

/// The joint between two vertices.
inline mesh::Index joint_between(const mesh::Mesh& mesh, Point a, Point b) {
  const mesh::Index first = vertex_at(mesh, a);
  const mesh::Index second = vertex_at(mesh, b);
  for (const mesh::Index j : mesh.vertex_joints.row(first)) {
    const auto& ends = mesh.joint[at(j)].vertex;
    if (ends[0] == second || ends[1] == second) {
      return j;
    }
  }
  throw std::logic_error("no joint between these places");
}

inline Point centroid(const mesh::Mesh& mesh, mesh::Index triangle) {
  const auto p = mesh.triangle_points(triangle);
  return (1.0 / 3.0) * (p[0] + p[1] + p[2]);
}

}  // namespace percolith::test
