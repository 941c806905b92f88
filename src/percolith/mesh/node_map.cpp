// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/node_map.hpp"

#include <algorithm>
#include <numeric>

namespace percolith::mesh {

NodeMap::NodeMap(const Mesh& mesh, std::span<const std::uint8_t> tied)
    : leader_(static_cast<std::size_t>(mesh.corners())),
      whole_(static_cast<std::size_t>(mesh.vertices()), 1) {
  std::iota(leader_.begin(), leader_.end(), 0);
  for (Index v = 0; v < mesh.vertices(); ++v) {
    refresh(mesh, tied, v);
  }
}

bool NodeMap::refresh(const Mesh& mesh, std::span<const std::uint8_t> tied, Index vertex) {
  const auto slot = [](Index corner) { return static_cast<std::size_t>(corner); };
  const auto corners = mesh.vertex_corners.row(vertex);
  std::vector<Index> before(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    before[i] = leader_[slot(corners[i])];
    leader_[slot(corners[i])] = corners[i];
  }
  // A fan has few corners: merge the two nodes of each tied joint under the lower leader.
  for (const Index j : mesh.vertex_joints.row(vertex)) {
    if (tied[static_cast<std::size_t>(j)] == 0) {
      continue;
    }
    const Joint& joint = mesh.joint[static_cast<std::size_t>(j)];
    const auto end = static_cast<std::size_t>(mesh.joint_end(j, vertex));
    const Index a = leader_[slot(joint.corner[0][end])];
    const Index b = leader_[slot(joint.corner[1][end])];
    for (const Index corner : corners) {
      if (leader_[slot(corner)] == std::max(a, b)) {
        leader_[slot(corner)] = std::min(a, b);
      }
    }
  }
  bool changed = false;
  bool whole = true;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    changed = changed || before[i] != leader_[slot(corners[i])];
    whole = whole && leader_[slot(corners[i])] == corners.front();
  }
  whole_[static_cast<std::size_t>(vertex)] = whole ? 1 : 0;
  return changed;
}

std::vector<Index> NodeMap::nodes(const Mesh& mesh) const {
  std::vector<Index> result;
  for (Index c = 0; c < mesh.corners(); ++c) {
    if (leader(c) == c && triangle_of(c) < mesh.triangles()) {
      result.push_back(c);
    }
  }
  return result;
}

}  // namespace percolith::mesh
