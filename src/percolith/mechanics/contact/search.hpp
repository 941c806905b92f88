// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/execution.hpp"
#include "percolith/mechanics/contact/candidates.hpp"
#include "percolith/mechanics/contact/placed_triangle.hpp"

#include <array>
#include <span>
#include <vector>

namespace percolith::mechanics {

/// Pairs of candidates that are near each other. Candidates go by their place in the list that was
/// searched.
struct PairList {
  std::vector<std::array<Index, 2>> pair;  ///< (a, b), a < b, ascending
  std::vector<Index> start;                ///< first pair of each a; candidates + 1
  mesh::IndexTable as_second;              ///< pairs in which a candidate is b, ascending
};

/// All pairs that may touch and are no more than `margin` (m) apart, as far as their boxes and
/// edges tell: none that is nearer is left out. By a uniform grid with cells of about the size of a
/// triangle, in time linear in the number of candidates (NBS class). Triangles whose places are not
/// finite are left out.
[[nodiscard]] PairList find_pairs(std::span<const Candidate> candidates,
                                  std::span<const PlacedTriangle> placed, double margin,
                                  Execution& execution);

/// The pairs of `find_pairs` that have one of the given triangles in it; both lists ascend, and the
/// triangles are candidates.
[[nodiscard]] std::vector<std::array<Index, 2>>
find_pairs_of(std::span<const Index> triangles, std::span<const Candidate> candidates,
              std::span<const PlacedTriangle> placed, double margin);

/// Whether two triangles are no more than `margin` apart: the test of `find_pairs`.
[[nodiscard]] bool are_near(const PlacedTriangle& a, const PlacedTriangle& b, double margin);

}  // namespace percolith::mechanics
