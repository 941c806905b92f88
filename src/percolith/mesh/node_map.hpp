// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace percolith::mesh {

/// Which corners share one unknown (theory.md section 1). The corners at a vertex that are
/// connected through tied joints form a node; the node is named by its lowest corner, its leader.
/// With no joint tied every corner is its own node. Displacement and pore pressure each have a map
/// of their own.
///
/// The map of a vertex depends only on which joints there are tied, not on the order in which they
/// were released: releasing joints one by one equals a rebuild.
class NodeMap {
public:
  /// `tied` holds one flag per joint.
  NodeMap(const Mesh& mesh, std::span<const std::uint8_t> tied);

  /// Rebuilds the nodes at one vertex from the present flags; true when any corner changed node.
  bool refresh(const Mesh& mesh, std::span<const std::uint8_t> tied, Index vertex);

  [[nodiscard]] Index leader(Index corner) const {
    return leader_[static_cast<std::size_t>(corner)];
  }
  /// Leader of every corner slot; padding slots lead themselves.
  [[nodiscard]] std::span<const Index> leaders() const { return leader_; }
  /// Per vertex: 1 when all its corners are one node.
  [[nodiscard]] std::span<const std::uint8_t> whole() const { return whole_; }
  /// The leaders of all nodes in ascending order.
  [[nodiscard]] std::vector<Index> nodes(const Mesh& mesh) const;
  /// Calls `visit(corner)` for the corners of a node, ascending.
  template <class Visit>
  void for_each_corner(const Mesh& mesh, Index node, const Visit& visit) const {
    for (const Index corner : mesh.vertex_corners.row(mesh.vertex_of(node))) {
      if (leader(corner) == node) {
        visit(corner);
      }
    }
  }

private:
  std::vector<Index> leader_;
  std::vector<std::uint8_t> whole_;
};

}  // namespace percolith::mesh
