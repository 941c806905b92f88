// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/crack_network.hpp"

#include <algorithm>

namespace percolith::mesh {
namespace {

/// Adds a sorted list to a sorted list.
void merge_into(std::vector<Index>& list, const std::vector<Index>& more) {
  const auto middle = static_cast<std::ptrdiff_t>(list.size());
  list.insert(list.end(), more.begin(), more.end());
  std::inplace_merge(list.begin(), list.begin() + middle, list.end());
}

}  // namespace

std::vector<Index> CrackNetwork::break_joints(const Mesh& mesh, std::span<const Index> joints) {
  std::vector<Index> new_joints;
  std::vector<Index> new_nodes;
  for (const Index j : joints) {
    std::uint8_t& flag = broken_[static_cast<std::size_t>(j)];
    if (flag != 0) {
      continue;
    }
    flag = 1;
    new_joints.push_back(j);
    for (const Index v : mesh.joint[static_cast<std::size_t>(j)].vertex) {
      if (broken_at_[static_cast<std::size_t>(v)]++ == 0) {
        new_nodes.push_back(v);
      }
    }
  }
  std::sort(new_joints.begin(), new_joints.end());
  std::sort(new_nodes.begin(), new_nodes.end());
  merge_into(joints_, new_joints);
  merge_into(nodes_, new_nodes);
  return new_joints;
}

}  // namespace percolith::mesh
