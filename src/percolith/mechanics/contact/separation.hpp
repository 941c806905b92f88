// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/simd.hpp"
#include "percolith/mechanics/contact/placed_triangle.hpp"

#include <array>

namespace percolith::mechanics {

/// Where the corners of one triangle lie as seen from the edges of another: twice the areas between
/// them, m2, [edge][corner], positive on the inner side.
template <class Real>
using BesideEdges = std::array<std::array<Real, 3>, 3>;

template <class Real>
PERCOLITH_DEVICE BesideEdges<Real> beside_edges(const std::array<Vec2<Real>, 3>& triangle,
                                                const std::array<Vec2<Real>, 3>& other) {
  BesideEdges<Real> beside;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      beside[i][k] = beside_edge(triangle, i, other[k]);
    }
  }
  return beside;
}

/// Of a pair: the corners of the second seen from the edges of the first, and the other way round.
template <class Real>
struct PairSides {
  BesideEdges<Real> second, first;
};

template <class Real>
PERCOLITH_DEVICE PairSides<Real> pair_sides(const PairPlaces<Real>& pair) {
  return {beside_edges(pair.first, pair.second), beside_edges(pair.second, pair.first)};
}

/// The innermost corner as seen from an edge, m2.
template <class Real>
PERCOLITH_DEVICE Real innermost(const BesideEdges<Real>& beside, std::size_t edge) {
  return larger(beside[edge][0], larger(beside[edge][1], beside[edge][2]));
}

/// True where an edge of either triangle has the other one beyond it: convex bodies overlap only if
/// none has. Both areas must be positive.
template <class Real>
PERCOLITH_DEVICE auto separated(const PairSides<Real>& sides) {
  Real least = smaller(innermost(sides.first, 0), innermost(sides.second, 0));
  for (std::size_t i = 1; i < 3; ++i) {
    least = smaller(least, smaller(innermost(sides.first, i), innermost(sides.second, i)));
  }
  return least <= Real(0.0);
}

/// 1/a, 1/b, 1/c by one division.
template <class Real>
PERCOLITH_DEVICE std::array<Real, 3> inverses(Real a, Real b, Real c) {
  const Real ab = a * b;
  const Real all = Real(1.0) / (ab * c);
  const Real rest = c * all;
  return {rest * b, rest * a, ab * all};
}

/// The widest gap between an edge of `triangle` and all of the other one, squared, m2; 0 where
/// there is none.
template <class Real>
PERCOLITH_DEVICE Real widest_gap_squared(const std::array<Vec2<Real>, 3>& triangle,
                                         const BesideEdges<Real>& beside) {
  std::array<Real, 3> length;  // squared
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2<Real> edge = triangle[next_corner(i)] - triangle[i];
    length[i] = dot(edge, edge);
  }
  const std::array<Real, 3> inverse = inverses(length[0], length[1], length[2]);
  Real widest(0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    const Real nearest = smaller(innermost(beside, i), Real(0.0));
    widest = larger(nearest * nearest * inverse[i], widest);
  }
  return widest;
}

/// How far apart two triangles of positive areas are at least, m.
template <class Real>
PERCOLITH_DEVICE Real gap_between(const PairPlaces<Real>& pair, const PairSides<Real>& sides) {
  return square_root(larger(widest_gap_squared(pair.first, sides.second),
                            widest_gap_squared(pair.second, sides.first)));
}

}  // namespace percolith::mechanics
