// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/contact/candidates.hpp"

#include <algorithm>

namespace percolith::mechanics {

bool may_touch(const Candidate& a, const Candidate& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.neighbour[k] == b.triangle) {
      return a.neighbour_touch[k] != 0;
    }
  }
  for (const Index first : a.leader) {
    for (const Index second : b.leader) {
      if (first == second) {
        return false;
      }
    }
  }
  return true;
}

void merge_candidates(std::span<const Candidate> changed, std::vector<Candidate>& candidates) {
  const auto lower = [](const Candidate& a, const Candidate& b) { return a.triangle < b.triangle; };
  const auto known = static_cast<std::ptrdiff_t>(candidates.size());
  for (const Candidate& c : changed) {
    const auto end = candidates.begin() + known;
    const auto found = std::lower_bound(candidates.begin(), end, c, lower);
    if (found != end && found->triangle == c.triangle) {
      *found = c;
    } else {
      candidates.push_back(c);
    }
  }
  std::inplace_merge(candidates.begin(), candidates.begin() + known, candidates.end(), lower);
}

std::vector<std::array<Index, 3>> joints_of_triangles(const mesh::Mesh& mesh) {
  std::vector<std::array<Index, 3>> joints(mesh.triangle_vertex.size(),
                                           {mesh::none, mesh::none, mesh::none});
  for (Index j = 0; j < mesh.joints(); ++j) {
    for (const auto& side : mesh.joint[at(j)].corner) {
      auto& own = joints[at(mesh::triangle_of(side[0]))];
      own[own[0] == mesh::none ? 0 : (own[1] == mesh::none ? 1 : 2)] = j;
    }
  }
  return joints;
}

}  // namespace percolith::mechanics
