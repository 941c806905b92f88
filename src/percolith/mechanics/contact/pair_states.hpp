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
  Index slot = 0;                   ///< of corner 0
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

/// A cache line: of the pairs that are listed only some are worked on.
inline constexpr std::size_t pair_alignment = 64;
inline constexpr Index pair_stride = pair_alignment / sizeof(double);

/// What a pair is.
struct alignas(pair_alignment) PairNature {
  Point apart;                        ///< m, from corner 0 of its first triangle to that of its
                                      ///< second, undeformed
  std::array<double, 2> stiffness{};  ///< p A0 of both triangles, N
  double tangential_penalty = 0.0;    ///< Pa/m
  double friction = 0.0;              ///< tan(phi)
  std::array<Index, 2> slot{};        ///< of corner 0 of both triangles
};

/// What a pair remembers from step to step. The normal force is max(0, factor |f| - offset) along
/// f, the integral (4).
template <class Real>
struct alignas(pair_alignment) PairState {
  Real factor = 1.0;
  Real offset = 0.0;      ///< N/m
  Real tangential = 0.0;  ///< N/m, on the first triangle along t: f turned by +90 degrees
  Real stored = 0.0;      ///< J/m, in the tangential spring
  Real loss = 0.0;        ///< J/m, tangential energy lost since the search
  Real depth = 0.0;       ///< m, extent of the overlap along f; 0 without overlap
};

/// The overlap from which a pair with an offset started: energy (J/m) and force (N/m) of the
/// integral (4).
struct PairOrigin {
  double energy = 0.0;
  double force = 0.0;
};

/// Forces on both triangles of the pairs of a block, N/m: x of corners 0, 1, 2 and then y, of the
/// first triangle and then of the second, eight each.
struct alignas(pair_alignment) PairForceBlock {
  static constexpr Index side = 6 * block_width;
  std::array<double, 2 * side> value;
};

/// What is kept for each pair that is listed, one entry each.
struct PairStates {
  std::vector<PairNature> nature;
  std::vector<PairState<double>> state;
  std::vector<PairOrigin> origin;
  std::vector<PairStart> start;
  /// Way from the search (m) up to which the triangles cannot meet.
  std::vector<double> rest;
  /// Where the forces of the last step start in the blocks: eight numbers further is the next one.
  /// `none` where the pair does not touch.
  std::vector<Index> force;

  [[nodiscard]] Index size() const { return static_cast<Index>(nature.size()); }
  void reserve(std::size_t pairs);
  /// A new pair that has not been looked at.
  void add(const Surface& a, const Surface& b);
  [[nodiscard]] std::array<Index, 2> triangles(Index pair) const {
    const auto& slot = nature[at(pair)].slot;
    return {mesh::triangle_of(slot[0]), mesh::triangle_of(slot[1])};
  }
};

/// Where the forces of a place start in the blocks.
PERCOLITH_DEVICE Index force_at(Index place) {
  return place / block_width * (2 * PairForceBlock::side) + place % block_width;
}

}  // namespace percolith::mechanics
