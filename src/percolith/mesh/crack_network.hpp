// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace percolith::mesh {

/// The broken joints and the vertices they end at, the open crack nodes. Both lists ascend, so the
/// network depends only on which joints are broken, not on the order in which they broke.
class CrackNetwork {
public:
  explicit CrackNetwork(const Mesh& mesh)
      : broken_(mesh.joint.size(), 0), broken_at_(mesh.vertex.size(), 0) {}

  /// Breaks joints; those already broken stay so. Returns the ones that broke now, ascending.
  std::vector<Index> break_joints(const Mesh& mesh, std::span<const Index> joints);

  [[nodiscard]] bool is_broken(Index joint) const {
    return broken_[static_cast<std::size_t>(joint)] != 0;
  }
  [[nodiscard]] bool is_open(Index vertex) const {
    return broken_at_[static_cast<std::size_t>(vertex)] > 0;
  }
  [[nodiscard]] std::span<const std::uint8_t> broken() const { return broken_; }
  [[nodiscard]] const std::vector<Index>& broken_joints() const { return joints_; }
  [[nodiscard]] const std::vector<Index>& open_nodes() const { return nodes_; }

private:
  std::vector<std::uint8_t> broken_;  // per joint
  std::vector<Index> broken_at_;      // broken joints per vertex
  std::vector<Index> joints_;
  std::vector<Index> nodes_;
};

}  // namespace percolith::mesh
