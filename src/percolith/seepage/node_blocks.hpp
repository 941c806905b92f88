// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/seepage/model.hpp"

#include <vector>

namespace percolith::seepage {

/// Vertices all of whose corners are one pore node, eight with equally many corners to a block, so
/// that a kernel can gather the corners of eight nodes at once; blocks as near each other in memory
/// as their vertices. All other vertices stand in a list of their own.
struct NodeBlocks {
  std::vector<Index> start;         ///< per block and one more: where its entries begin
  std::vector<Index> corner;        ///< [block][k][node]: k-th corner of the node, ascending in k
  std::vector<Index> triangle;      ///< the same: its triangle
  std::vector<double> storage;      ///< [block][node]: of the node, m2/Pa
  std::vector<double> void_volume;  ///< [block][node]: m2
  std::vector<Index> single;        ///< the other vertices, ascending

  /// Nodes in the blocks.
  [[nodiscard]] Index nodes() const { return static_cast<Index>(start.size() - 1) * block_width; }
};

/// The blocks of a model as its nodes are now.
[[nodiscard]] NodeBlocks node_blocks(const Model& model);

}  // namespace percolith::seepage
