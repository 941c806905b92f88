// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/node_blocks.hpp"

#include <algorithm>
#include <array>

namespace percolith::seepage {
namespace {

using Block = std::array<Index, block_width>;

void append(NodeBlocks& blocks, const Model& model, const Block& block) {
  const mesh::Mesh& mesh = model.mesh;
  const std::size_t corners = mesh.vertex_corners.row(block.front()).size();
  for (std::size_t k = 0; k < corners; ++k) {
    for (const Index vertex : block) {
      const Index corner = mesh.vertex_corners.row(vertex)[k];
      blocks.corner.push_back(corner);
      blocks.triangle.push_back(mesh::triangle_of(corner));
    }
  }
  for (const Index vertex : block) {
    const auto node = at(mesh.vertex_corners.row(vertex).front());
    blocks.storage.push_back(model.state.storage[node]);
    blocks.void_volume.push_back(model.state.void_volume[node]);
  }
  blocks.start.push_back(static_cast<Index>(blocks.corner.size()));
}

}  // namespace

NodeBlocks node_blocks(const Model& model) {
  const mesh::Mesh& mesh = model.mesh;
  NodeBlocks blocks;
  std::vector<std::vector<Index>> waiting;  // by the number of corners
  std::vector<Block> full;
  for (Index v = 0; v < mesh.vertices(); ++v) {
    const std::size_t corners = mesh.vertex_corners.row(v).size();
    if (model.pore_nodes.whole()[at(v)] == 0 || corners == 0) {
      blocks.single.push_back(v);
      continue;
    }
    waiting.resize(std::max(waiting.size(), corners + 1));
    std::vector<Index>& alike = waiting[corners];
    alike.push_back(v);
    if (alike.size() == block_width) {
      std::copy(alike.begin(), alike.end(), full.emplace_back().begin());
      alike.clear();
    }
  }
  for (const std::vector<Index>& alike : waiting) {
    blocks.single.insert(blocks.single.end(), alike.begin(), alike.end());
  }
  std::sort(blocks.single.begin(), blocks.single.end());
  blocks.start.push_back(0);
  // A block is full when its last vertex comes: they stand in the order of their last vertices.
  for (const Block& block : full) {
    append(blocks, model, block);
  }
  return blocks;
}

}  // namespace percolith::seepage
