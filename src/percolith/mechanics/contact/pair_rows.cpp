// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/contact/pair_rows.hpp"

#include <algorithm>

namespace percolith::mechanics {
namespace {

/// The triangle an entry leads to.
Index partner(const PairStates& states, Index entry) {
  return states.triangles(entry / 2)[at(1 - entry % 2)];
}

}  // namespace

PairRows::PairRows(const PairStates& states, Index triangles) : rows_(at(triangles)) {
  for (Index p = 0; p < states.size(); ++p) {
    for (const Index t : states.triangles(p)) {
      ++rows_[at(t)].room;
    }
  }
  Index start = 0;
  for (Row& row : rows_) {
    row.start = start;
    start += row.room;
  }
  entries_.resize(at(start));
  // Every row meets its lower partners before its higher ones, each in ascending order.
  for (Index p = 0; p < states.size(); ++p) {
    const auto pair = states.triangles(p);
    for (Index side = 0; side < 2; ++side) {
      Row& row = rows_[at(pair[at(side)])];
      entries_[at(row.start + row.count++)] = 2 * p + side;
    }
  }
}

Index PairRows::place_of(const PairStates& states, Index triangle, Index other) const {
  const auto own = row(triangle);
  return static_cast<Index>(
      std::lower_bound(own.begin(), own.end(), other,
                       [&](Index entry, Index wanted) { return partner(states, entry) < wanted; }) -
      own.begin());
}

Index PairRows::find(const PairStates& states, Index triangle, Index other) const {
  if (triangle >= static_cast<Index>(rows_.size())) {
    return mesh::none;
  }
  const auto own = row(triangle);
  const Index place = place_of(states, triangle, other);
  const bool there =
      place < static_cast<Index>(own.size()) && partner(states, own[at(place)]) == other;
  return there ? own[at(place)] / 2 : mesh::none;
}

void PairRows::insert(const PairStates& states, Index pair) {
  const auto [a, b] = states.triangles(pair);
  insert(states, a, b, 2 * pair);
  insert(states, b, a, 2 * pair + 1);
}

void PairRows::insert(const PairStates& states, Index triangle, Index other, Index entry) {
  const Index place = place_of(states, triangle, other);
  Row& row = rows_[at(triangle)];
  if (row.count == row.room) {
    // A full row moves to the end, where it has room.
    const Index start = row.start;
    row.start = static_cast<Index>(entries_.size());
    row.room = 2 * row.room + 4;
    entries_.resize(entries_.size() + at(row.room));
    std::copy_n(entries_.begin() + start, row.count, entries_.begin() + row.start);
  }
  const auto first = entries_.begin() + row.start;
  std::copy_backward(first + place, first + row.count, first + row.count + 1);
  *(first + place) = entry;
  ++row.count;
}

}  // namespace percolith::mechanics
