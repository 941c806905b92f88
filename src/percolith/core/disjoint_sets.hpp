// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/index.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace percolith {

/// Numbers that are merged into sets; each set is known by its lowest number.
class DisjointSets {
public:
  /// The numbers 0 to n-1, each a set of its own.
  explicit DisjointSets(Index n) : parent_(at(n)) { std::iota(parent_.begin(), parent_.end(), 0); }

  /// Lowest number of the set of `i`; ways to it are shortened.
  [[nodiscard]] Index root(Index i) {
    while (parent_[at(i)] != i) {
      parent_[at(i)] = parent_[at(parent_[at(i)])];
      i = parent_[at(i)];
    }
    return i;
  }

  void merge(Index a, Index b) {
    const Index first = root(a);
    const Index second = root(b);
    parent_[at(std::max(first, second))] = std::min(first, second);
  }

private:
  std::vector<Index> parent_;
};

}  // namespace percolith
