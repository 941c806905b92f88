// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/simd.hpp"
#include "percolith/mechanics/contact/placed_triangle.hpp"

#include <array>
#include <cstdint>

namespace percolith::mechanics {

/// True where an edge of either triangle has the other one beyond it: convex bodies overlap only if
/// none has. `edge` (0..2 of the first, 3..5 of the second) is tried first and left at the edge
/// that was found: from one step to the next it is mostly the same. Both areas must be positive.
[[nodiscard]] bool separated(const PlacedPair& pair, std::uint8_t& edge);

/// The edges of both triangles, each with its part within the other one: 0..2 of the first, 3..5 of
/// the second, the rest empty. Laid out for vector registers.
struct alignas(64) EdgeParts {
  using Row = std::array<double, block_width>;
  Row x, y;        ///< m, where the edge starts
  Row dx, dy;      ///< m, from there to its end
  Row start, end;  ///< the part, as shares of the edge; equal where it is empty
};

/// The normal force of two triangles that overlap, (4), with the potential (5), and where it acts.
struct OverlapForce {
  std::array<std::array<Point, 3>, 2> on;  ///< N/m, [triangle][corner]
  Point total;                             ///< N/m, on the first triangle
  /// Weights of the corners of each triangle at the centre of pressure; all zero without overlap.
  std::array<std::array<double, 3>, 2> centre;
  EdgeParts rim;  ///< what bounds the overlap
};

/// Integrates (4) exactly over the boundary of the overlap:
///
///     f = integral of n (p_a phi_a - p_b phi_b) ds,   phi = 3 min(lambda_1, lambda_2, lambda_3)
///
/// phi_a is zero on the edges of a, so that each edge carries the potential of the other triangle,
/// piecewise linear. Every force acts on both triangles at one point, by the area coordinates
/// lambda there: momentum and angular momentum are kept to round-off.
///
/// `penalty` (Pa) weighs the potential of each triangle. With p_a = p A0_a/A_a, A0 the undeformed
/// area, the corner forces are the exact derivative of the energy
/// p (A0_a/A_a int phi_a dA + A0_b/A_b int phi_b dA) even where the triangles deform.
[[nodiscard]] OverlapForce overlap_force(const PlacedPair& pair,
                                         const std::array<double, 2>& penalty);

/// Length of the overlap along a unit vector, m.
[[nodiscard]] double extent_along(const OverlapForce& overlap, const Point& direction);

}  // namespace percolith::mechanics
