// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/archive.hpp"
#include "percolith/mechanics/contact/pair_states.hpp"

#include <span>
#include <vector>

namespace percolith::mechanics {

/// An entry of a row of pairs: twice the number of the pair, plus one where the triangle whose row
/// it is is the second one.
constexpr Index pair_entry(Index pair, Index side) {
  return 2 * pair + side;
}
constexpr Index pair_of(Index entry) {
  return entry >> 1;
}
constexpr Index side_of(Index entry) {
  return entry & 1;
}

/// The pairs of every triangle, ascending in the triangle they are with.
class PairRows {
public:
  PairRows() = default;
  /// Of pairs that are ascending.
  PairRows(const PairStates& states, Index triangles);

  [[nodiscard]] std::span<const Index> row(Index triangle) const {
    const Row& r = rows_[at(triangle)];
    return std::span<const Index>(entries_).subspan(at(r.start), at(r.count));
  }
  /// The pair of two triangles, or `none`.
  [[nodiscard]] Index find(const PairStates& states, Index triangle, Index other) const;
  /// Enters a pair that is not there yet into the rows of both of its triangles.
  void insert(const PairStates& states, Index pair);
  void describe_state(StateArchive& archive);

private:
  struct Row {
    Index start = 0, count = 0, room = 0;
    void describe_state(StateArchive& archive);
  };
  [[nodiscard]] Index place_of(const PairStates& states, Index triangle, Index other) const;
  void insert(const PairStates& states, Index triangle, Index other, Index entry);

  std::vector<Row> rows_;
  std::vector<Index> entries_;
};

}  // namespace percolith::mechanics
