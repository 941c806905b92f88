// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/corner.hpp"
#include "percolith/mesh/gmsh_mesh.hpp"

#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace percolith::mesh {

/// Rows of indices of different lengths, one row after the other.
struct IndexTable {
  std::vector<Index> start;  ///< rows + 1
  std::vector<Index> entry;
  [[nodiscard]] std::span<const Index> row(Index i) const {
    const auto k = static_cast<std::size_t>(i);
    return std::span<const Index>(entry).subspan(static_cast<std::size_t>(start[k]),
                                                 static_cast<std::size_t>(start[k + 1] - start[k]));
  }
};

/// An interior edge with the four corners that meet there. Side 0 is the triangle with the lower
/// number; end 0 is where the edge starts when one walks counter-clockwise round that triangle.
struct Joint {
  std::array<Index, 2> vertex;                 ///< [end]
  std::array<std::array<Index, 2>, 2> corner;  ///< [side][end]
};

/// An edge of one triangle only, in counter-clockwise order.
struct BoundaryEdge {
  std::array<Index, 2> vertex;
  std::array<Index, 2> corner;
};

/// What a named curve consists of. `loose` edges are no edges of the triangulation.
struct CurveEdges {
  std::vector<Index> joints;
  std::vector<Index> boundary;
  std::vector<std::array<Index, 2>> loose;  ///< point numbers of the file
};

/// A triangulation and everything that follows from it once and for all: it does not change when
/// joints break. Triangles run counter-clockwise and are numbered along a space-filling curve, so
/// that neighbours are close in memory.
struct Mesh {
  std::vector<Point> vertex;                          ///< m
  std::vector<std::array<Index, 3>> triangle_vertex;  ///< [triangle][local]
  std::vector<Index> region;                          ///< per triangle, index of region_names
  std::vector<std::string> region_names;
  std::vector<Joint> joint;
  std::vector<BoundaryEdge> boundary;
  IndexTable vertex_corners;  ///< corners at each vertex, ascending
  IndexTable vertex_joints;   ///< joints that end at each vertex, ascending
  std::map<std::string, CurveEdges> curves;
  std::map<std::string, std::vector<Index>> point_groups;  ///< vertices

  [[nodiscard]] Index triangles() const { return static_cast<Index>(triangle_vertex.size()); }
  [[nodiscard]] Index vertices() const { return static_cast<Index>(vertex.size()); }
  [[nodiscard]] Index joints() const { return static_cast<Index>(joint.size()); }
  [[nodiscard]] Index corners() const { return corner_slots(triangles()); }
  [[nodiscard]] Index vertex_of(Index corner) const {
    return triangle_vertex[static_cast<std::size_t>(triangle_of(corner))]
                          [static_cast<std::size_t>(local_of(corner))];
  }
  [[nodiscard]] const Point& place_of(Index corner) const {
    return vertex[static_cast<std::size_t>(vertex_of(corner))];
  }
  [[nodiscard]] std::array<Point, 3> triangle_points(Index triangle) const;
  /// Centre of a triangle's area, m.
  [[nodiscard]] Point triangle_centre(Index triangle) const;
  /// Point half-way between two vertices, those of a joint or of a boundary edge, m.
  [[nodiscard]] Point middle_of(const std::array<Index, 2>& ends) const;
  /// Area of a triangle, m2 (positive).
  [[nodiscard]] double area(Index triangle) const;
  /// Length of a joint, m.
  [[nodiscard]] double joint_length(Index joint) const;
  /// End (0 or 1) of a joint at a vertex it ends at.
  [[nodiscard]] Index joint_end(Index joint, Index vertex) const;
};

/// Orients, orders and connects a checked mesh. Throws InputError (key `mesh.file`) when an edge
/// belongs to more than two triangles.
[[nodiscard]] Mesh build_mesh(const GmshMesh& file);

}  // namespace percolith::mesh
