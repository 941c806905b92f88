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

/// Forces and states of the listed pairs after a step of length `dt` (s), (4)-(7). Of each chunk
/// the pairs that may meet are put side by side, as many as a register holds.
struct PairForces {
  PairStates* states;
  PairRecords* records;
  const CornerPlaces* undeformed;
  CornerMotion motion;
  std::span<const PairHandOver> handed;  ///< ascending pairs
  double travelled = 0.0;                ///< m, way of any corner since the search at most
  double dt = 0.0;                       ///< s
  bool starts = true;                    ///< whether any pair is looked at for the first time

  template <class Lane>
  void operator()(Lane lane, Index end) const {
    std::array<Index, pair_chunk + block_width> active;
    Index count = 0;
    for (Index p = lane.first; p < end; ++p) {
      active[at(count)] = p;
      count += states->rest[at(p)] > travelled ? 0 : 1;
    }
    if (count == 0) {
      return;
    }
    // What is left of the last register repeats a pair of it, and comes to the same.
    std::fill_n(active.begin() + count, block_width, active[at(count) - 1]);
    for (Index k = 0; k < count; k += Lane::width) {
      advance<Lane>(active.data() + k, std::min(count - k, Lane::width), lane.first + k);
    }
  }

private:
  /// Handles the pairs of a lane, of which `count` are different, and puts their records from
  /// `place` on.
  template <class Lane>
  void advance(const Index* pair, Index count, Index place) const;
};

extern template void PairForces::advance<ScalarLane>(const Index*, Index, Index) const;
extern template void PairForces::advance<VectorLane>(const Index*, Index, Index) const;

}  // namespace percolith::mechanics
