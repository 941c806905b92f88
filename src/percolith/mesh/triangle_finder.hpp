// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/mesh.hpp"

#include <array>
#include <optional>
#include <vector>

namespace percolith::mesh {

/// A point within a triangle: weights of its three corners, not negative, sum 1.
struct PlaceInTriangle {
  Index triangle = 0;
  std::array<double, 3> weight{};
};

/// Finds the triangle a point lies in by a uniform grid over the mesh. Of several (a point on an
/// edge) the one with the lowest number is taken. The mesh must outlive the finder.
class TriangleFinder {
public:
  explicit TriangleFinder(const Mesh& mesh);
  /// Absent where the point lies outside of every triangle by more than round-off.
  [[nodiscard]] std::optional<PlaceInTriangle> find(const Point& p) const;

private:
  [[nodiscard]] std::array<Index, 2> cell_of(const Point& p) const;
  const Mesh* mesh_;
  Point low_;
  double size_ = 1.0;  // of a cell, m
  Index columns_ = 1, rows_ = 1;
  IndexTable cells_;  // triangles whose bounding box touches the cell
};

}  // namespace percolith::mesh
