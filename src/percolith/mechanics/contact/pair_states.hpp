// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/contact/candidates.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace percolith::mechanics {

/// What a triangle brings to its pairs.
struct Surface {
  double penalty = 0.0;             ///< p_n of (4), Pa
  double tangential_penalty = 0.0;  ///< p_t of (6), Pa/m
  double friction = 0.0;            ///< tan(phi) of (7)
  double twice_area = 0.0;          ///< m2, undeformed
  Point origin;                     ///< m, undeformed place of corner 0
};

/// The penalty of a pair: both in series, twice as stiff as the softer one at most.
inline double in_series(double a, double b) {
  return a == b ? a : 2.0 * a * b / (a + b);
}

/// How a pair takes up its force when it is looked at for the first time.
enum class PairStart : std::uint8_t {
  none,   ///< it has been looked at
  fresh,  ///< an overlap that is already there gives no force of its own
  handed  ///< it carries on the force of a joint
};

/// What is kept for each pair that is listed, one entry each.
struct PairStates {
  // What the pair is.
  std::vector<Index> first, second;        ///< slots of corner 0 of its triangles
  std::vector<double> apart_x, apart_y;    ///< m, undeformed, from the first to the second of them
  std::vector<double> stiffness_first;     ///< p A0 of each triangle, N
  std::vector<double> stiffness_second;    ///< as above
  std::vector<double> tangential_penalty;  ///< Pa/m
  std::vector<double> friction;            ///< tan(phi)

  // What it remembers from step to step. The normal force is max(0, factor |f| - offset) along f,
  // the integral (4).
  std::vector<double> factor;
  std::vector<double> offset;      ///< N/m
  std::vector<double> tangential;  ///< N/m, on the first triangle along t: f turned by +90 degrees
  std::vector<double> stored;      ///< J/m, in the tangential spring
  std::vector<double> loss;        ///< J/m, tangential energy lost since the search
  std::vector<double> depth;       ///< m, extent of the overlap along f; 0 without overlap
  std::vector<PairStart> start;

  /// Way from the search (m) up to which the triangles cannot meet.
  std::vector<double> rest;
  /// Where the forces of the last step are, see `force_at`; `none` where the pair does not touch.
  std::vector<Index> place;

  [[nodiscard]] Index size() const { return static_cast<Index>(first.size()); }
  void reserve(std::size_t pairs);
  /// A new pair that has not been looked at; triangles are given by the slots of their corners 0.
  void add(Index first_slot, Index second_slot, const Surface& a, const Surface& b);
  [[nodiscard]] std::array<Index, 2> triangles(Index pair) const {
    return {mesh::triangle_of(first[at(pair)]), mesh::triangle_of(second[at(pair)])};
  }
};

/// What the pairs that touch came to in the last step, by the places they were given. Only grows,
/// and is never cleared.
struct PairRecords {
  std::vector<double> force;     ///< N/m, see `force_at`
  std::vector<double> position;  ///< m, that the forces belong to, see `position_at`
  void make_room(Index pairs);
};

/// Forces in a block of places: x of corners 0, 1, 2 and then y, of the first triangle and then of
/// the second, eight each.
inline constexpr Index forces_of_side = 6 * block_width;
inline constexpr Index forces_of_block = 2 * forces_of_side;
/// Positions in a block: x and y of corners 1 and 2 of the first triangle, then of corners 0, 1, 2
/// of the second.
inline constexpr Index positions_of_block = 10 * block_width;

PERCOLITH_DEVICE Index force_at(Index place) {
  return place / block_width * forces_of_block + place % block_width;
}
PERCOLITH_DEVICE Index position_at(Index place) {
  return place / block_width * positions_of_block + place % block_width;
}

}  // namespace percolith::mechanics
