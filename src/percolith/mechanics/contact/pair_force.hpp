// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/execution.hpp"
#include "percolith/mechanics/contact/overlap_force.hpp"
#include "percolith/mechanics/contact/pair_states.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace percolith::mechanics {

/// Force that a joint hands to the contact of its faces, for a listed pair.
struct PairHandOver {
  Index pair = 0;
  double normal_force = 0.0;  ///< N/m, compression positive
  Point shear;                ///< N/m, on the first triangle
  double largest_factor = 1.0;
};

/// Displacements (m) and velocities (m/s) of the corners, one entry a corner slot.
struct CornerMotion {
  std::span<const double> ux, uy, vx, vy;
};

/// Undeformed places of the corners as seen from corner 0 of their triangle, m, one entry a slot.
struct CornerPlaces {
  std::vector<double> x, y;
};

/// Pairs that are handled together: a multiple of the block width.
inline constexpr Index pair_chunk = 256;

/// Pairs picked from a chunk.
struct PairPick {
  Index count = 0;
  std::array<Index, pair_chunk + block_width> pair;
  void add(Index p, bool picked) {
    pair[at(count)] = p;
    count += picked ? 1 : 0;
  }
  /// What is left of the last register repeats a pair of it, and comes to the same.
  void fill_up() {
    if (count > 0) {
      std::fill_n(pair.begin() + count, block_width, pair[at(count) - 1]);
    }
  }
};

/// Forces and states of the listed pairs after a step of length `dt` (s), (4)-(7). Of each chunk
/// the pairs that may meet are put side by side, as many as a register holds: first those that were
/// apart, to see whether they are now, then all that touch or touched.
struct PairForces {
  PairStates* states;
  PairForceBlock* forces;  ///< room for all pairs
  const CornerPlaces* undeformed;
  CornerMotion motion;
  std::span<const PairHandOver> handed;  ///< ascending pairs
  double travelled = 0.0;                ///< m, way of any corner since the search at most
  double dt = 0.0;                       ///< s
  bool starts = true;                    ///< whether any pair is looked at for the first time

  template <class Lane>
  void operator()(Lane lane, Index end) const {
    PairPick awake;
    for (Index p = lane.first; p < end; ++p) {
      awake.add(p, !(states->rest[at(p)] > travelled));
    }
    PairPick pressed;
    PairPick apart;
    for (Index i = 0; i < awake.count; ++i) {
      const Index p = awake.pair[at(i)];
      const bool known = starts || states->force[at(p)] != mesh::none;
      pressed.add(p, known);
      apart.add(p, !known);
    }
    apart.fill_up();
    for (Index k = 0; k < apart.count; k += Lane::width) {
      look<Lane>(apart.pair.data() + k, std::min(apart.count - k, Lane::width), pressed);
    }
    pressed.fill_up();
    for (Index k = 0; k < pressed.count; k += Lane::width) {
      fetch(pressed.pair.data() + std::min(k + pairs_ahead, pressed.count));
      advance<Lane>(pressed.pair.data() + k, std::min(pressed.count - k, Lane::width),
                    lane.first + k);
    }
  }

private:
  /// So many pairs further on is what is asked for early.
  static constexpr Index pairs_ahead = 4 * block_width;

  /// Asks for the lines of a block of pairs.
  void fetch(const Index* pair) const {
    for (Index i = 0; i < block_width; ++i) {
      prefetch(&states->nature[at(pair[i])].apart.x);
      prefetch(&states->state[at(pair[i])].factor);
    }
  }
  /// Looks whether pairs that were apart touch now, and adds those to `pressed`.
  template <class Lane>
  void look(const Index* pair, Index count, PairPick& pressed) const;
  /// Handles the pairs of a lane, of which `count` are different, and puts their forces from
  /// `place` on.
  template <class Lane>
  void advance(const Index* pair, Index count, Index place) const;
  template <class Lane>
  void note(const Index* pair, Index count, Index place, typename Lane::Real touching) const;
};

extern template void PairForces::look<ScalarLane>(const Index*, Index, PairPick&) const;
extern template void PairForces::look<VectorLane>(const Index*, Index, PairPick&) const;
extern template void PairForces::advance<ScalarLane>(const Index*, Index, Index) const;
extern template void PairForces::advance<VectorLane>(const Index*, Index, Index) const;

}  // namespace percolith::mechanics
