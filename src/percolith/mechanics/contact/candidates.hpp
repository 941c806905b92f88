// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/mesh.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace percolith::mechanics {

using mesh::Index;

/// A triangle that may come into contact, and which others it is bonded to.
struct Candidate {
  Index triangle = 0;
  std::array<Index, 3> leader{};                  ///< of its corners, see ContactTopology::fans
  std::array<Index, 3> neighbour{};               ///< triangle across each joint, or none
  std::array<std::uint8_t, 3> neighbour_touch{};  ///< 1 where the faces of that joint may touch
};

/// False for triangles that are bonded round a vertex or whose common joint acts itself.
[[nodiscard]] bool may_touch(const Candidate& a, const Candidate& b);

/// Replaces the candidates of the same triangles and enters the others; both ascend.
void merge_candidates(std::span<const Candidate> changed, std::vector<Candidate>& candidates);

/// The joints of every triangle, `none` where it has fewer than three.
[[nodiscard]] std::vector<std::array<Index, 3>> joints_of_triangles(const mesh::Mesh& mesh);

}  // namespace percolith::mechanics
