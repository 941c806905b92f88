// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/contact/edge_load.hpp"
#include "percolith/mechanics/contact/placed_triangle.hpp"
#include "percolith/mechanics/contact/separation.hpp"

#include <array>

namespace percolith::mechanics {

/// The normal force of two triangles that overlap, (4), with the potential (5), and where it acts.
template <class Real>
struct OverlapForces {
  std::array<std::array<Vec2<Real>, 3>, 2> on;  ///< N/m, [triangle][corner]
  Vec2<Real> total;                             ///< N/m, on the first triangle
  /// Weights of the corners of each triangle at the centre of pressure; all zero without overlap.
  std::array<std::array<Real, 3>, 2> centre;
  std::array<Vec2<Real>, 6> rim;  ///< m, the corners of the overlap; some may be given repeatedly
};
using OverlapForce = OverlapForces<double>;

/// A force (N/m) and its weight at the centre of pressure.
template <class Real>
struct Push {
  Vec2<Real> force;
  Real weight;
  PERCOLITH_DEVICE void add(Real share, const Push& push) {
    force = force + share * push.force;
    weight = weight + share * push.weight;
  }
};

template <class Real>
using CornerPushes = std::array<Push<Real>, 3>;

/// Sums over the edges of both triangles.
template <class Real>
struct OverlapSums {
  CornerPushes<Real> first{}, second{};
  std::array<Vec2<Real>, 6> rim{};
  std::array<Real, 6> part{};  ///< length of the part of each edge within the other triangle, as t
};

/// Adds what the edges of triangle `own` meet of the other one: `beside` sees the corners of `own`
/// from the edges of the other one, of which `twice_area` (m2) and `penalty` (Pa) are given.
template <class Real>
PERCOLITH_DEVICE void add_edges(const std::array<Vec2<Real>, 3>& own,
                                const BesideEdges<Real>& beside, Real twice_area, Real penalty,
                                std::size_t place, CornerPushes<Real>& on_own,
                                CornerPushes<Real>& on_other, OverlapSums<Real>& sums) {
  // The potential is three times the smallest coordinate.
  const Real stiffness = Real(3.0) * penalty;
  const Real inverse = Real(1.0) / twice_area;
  std::array<std::array<Real, 3>, 3> lambda;  // [corner][coordinate]
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      lambda[k][i] = inverse * beside[next_corner(i)][k];
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t last = next_corner(k);
    const EdgeLoad<Real> load = edge_load(lambda[k], lambda[last]);
    const Vec2<Real> edge = own[last] - own[k];
    const Vec2<Real> inward{-(stiffness * edge.y), stiffness * edge.x};
    const Real weight = square_root(dot(inward, inward));
    const Push<Real> push{inward, weight};
    const Push<Real> opposite{{-inward.x, -inward.y}, weight};
    on_own[k].add(load.at_start, push);
    on_own[last].add(load.at_end, push);
    for (std::size_t i = 0; i < 3; ++i) {
      on_other[i].add(lambda[k][i] * load.at_start + lambda[last][i] * load.at_end, opposite);
    }
    sums.rim[place + k] = own[k] + load.start * edge;
    sums.part[place + k] = load.end - load.start;
  }
}

/// The corners of the overlap: where the parts of the edges start, for each part goes on from where
/// another one ends. Edges without a part repeat one of them.
template <class Real>
PERCOLITH_DEVICE std::array<Vec2<Real>, 6> rim_of(const OverlapSums<Real>& sums) {
  const Real zero(0.0);
  Vec2<Real> any_corner{zero, zero};
  for (std::size_t e = 0; e < 6; ++e) {
    const auto inside = sums.part[e] > zero;
    any_corner = {select(inside, sums.rim[e].x, any_corner.x),
                  select(inside, sums.rim[e].y, any_corner.y)};
  }
  std::array<Vec2<Real>, 6> rim;
  for (std::size_t e = 0; e < 6; ++e) {
    const auto inside = sums.part[e] > zero;
    rim[e] = {select(inside, sums.rim[e].x, any_corner.x),
              select(inside, sums.rim[e].y, any_corner.y)};
  }
  return rim;
}

/// Integrates (4) exactly over the boundary of the overlap:
///
///     f = integral of n (p_a phi_a - p_b phi_b) ds,   phi = 3 min(lambda_1, lambda_2, lambda_3)
///
/// phi_a is zero on the edges of a, so that each edge carries the potential of the other triangle,
/// piecewise linear. Every force acts on both triangles at one point, by the area coordinates
/// lambda there: momentum and angular momentum are kept to round-off.
///
/// `penalty` (Pa) weighs the potential of each triangle, `twice_area` (m2) is that of each,
/// positive. With p_a = p A0_a/A_a, A0 the undeformed area, the corner forces are the exact
/// derivative of the energy p (A0_a/A_a int phi_a dA + A0_b/A_b int phi_b dA) even where the
/// triangles deform.
template <class Real>
PERCOLITH_DEVICE OverlapForces<Real>
overlap_force(const PairPlaces<Real>& pair, const PairSides<Real>& sides,
              const std::array<Real, 2>& twice_area, const std::array<Real, 2>& penalty) {
  OverlapSums<Real> sums;
  add_edges(pair.first, sides.first, twice_area[1], penalty[1], 0, sums.first, sums.second, sums);
  add_edges(pair.second, sides.second, twice_area[0], penalty[0], 3, sums.second, sums.first, sums);
  OverlapForces<Real> result;
  const std::array<const CornerPushes<Real>*, 2> pushes{&sums.first, &sums.second};
  for (std::size_t side = 0; side < 2; ++side) {
    const CornerPushes<Real>& p = *pushes[side];
    const Real sum = p[0].weight + p[1].weight + p[2].weight;
    const auto some = sum > Real(0.0);
    const Real inverse = select(some, Real(1.0) / select(some, sum, Real(1.0)), Real(0.0));
    for (std::size_t k = 0; k < 3; ++k) {
      result.on[side][k] = p[k].force;
      result.centre[side][k] = inverse * p[k].weight;
    }
  }
  result.total = result.on[0][0] + result.on[0][1] + result.on[0][2];
  result.rim = rim_of(sums);
  return result;
}

inline OverlapForce overlap_force(const PlacedPair& pair, const std::array<double, 2>& penalty) {
  return overlap_force(pair, pair_sides(pair), {twice_area(pair.first), twice_area(pair.second)},
                       penalty);
}

/// Length of the overlap along a unit vector, m.
template <class Real>
PERCOLITH_DEVICE Real extent_along(const OverlapForces<Real>& overlap,
                                   const Vec2<Real>& direction) {
  Real low = dot(overlap.rim[0], direction);
  Real high = low;
  for (std::size_t e = 1; e < 6; ++e) {
    const Real place = dot(overlap.rim[e], direction);
    low = smaller(place, low);
    high = larger(place, high);
  }
  return high - low;
}

}  // namespace percolith::mechanics
