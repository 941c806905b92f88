// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/contact/candidates.hpp"

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
