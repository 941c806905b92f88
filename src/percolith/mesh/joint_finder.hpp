// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/mesh.hpp"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace percolith::mesh {

/// A point projected onto a joint, `fraction` of the way from end 0 to end 1.
struct PlaceOnJoint {
  Index joint = 0;
  double fraction = 0.0;
  double distance = 0.0;  ///< m, from the point to its projection
};

/// The nearest of `joints` (the lowest number of several); absent without joints.
[[nodiscard]] std::optional<PlaceOnJoint>
nearest_joint(const Mesh& mesh, std::span<const Index> joints, const Point& p);

/// Finds all joints close to a point by a grid of squares. The mesh must outlive the finder.
class JointFinder {
public:
  /// Of `joints`, those count as close from which a point is at most `share` of their length away.
  JointFinder(const Mesh& mesh, std::span<const Index> joints, double share);
  /// Nearest first; the lowest number first of several.
  [[nodiscard]] std::vector<PlaceOnJoint> near(const Point& p) const;

private:
  /// Column and row, whole numbers that a point may lie too far away for integers to hold.
  using Square = std::pair<double, double>;
  [[nodiscard]] Square square_of(const Point& p) const;
  const Mesh* mesh_;
  double share_;
  double size_ = 1.0;                                // of a square, m: no joint is close to a point
                                                     // beyond the squares beside that of its middle
  std::vector<std::pair<Square, Index>> by_square_;  // each joint in that of its middle, sorted
};

}  // namespace percolith::mesh
