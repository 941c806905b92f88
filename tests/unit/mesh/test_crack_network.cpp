// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/crack_network.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include "unit/support/grid.hpp"
#include "unit/support/places.hpp"

namespace percolith::mesh {
namespace {

using test::at;

Mesh irregular() {
  return build_mesh(
      test::make_grid({.columns = 9, .rows = 8, .jitter = 0.3, .mixed_diagonals = true}));
}

TEST(CrackNetwork, StartsClosed) {
  const Mesh mesh = irregular();
  const CrackNetwork network(mesh);
  EXPECT_TRUE(network.broken_joints().empty());
  EXPECT_TRUE(network.open_nodes().empty());
  EXPECT_FALSE(network.is_open(0));
  EXPECT_EQ(network.broken().size(), mesh.joint.size());
}

TEST(CrackNetwork, ReturnsWhatBrokeNowAndIgnoresRepeats) {
  const Mesh mesh = irregular();
  CrackNetwork network(mesh);
  const std::vector<Index> first{9, 3, 9, 40};
  EXPECT_EQ(network.break_joints(mesh, first), (std::vector<Index>{3, 9, 40}));
  const std::vector<Index> second{40, 5, 3};
  EXPECT_EQ(network.break_joints(mesh, second), (std::vector<Index>{5}));
  EXPECT_EQ(network.broken_joints(), (std::vector<Index>{3, 5, 9, 40}));
}

class RandomBreaking : public testing::TestWithParam<unsigned> {};

TEST_P(RandomBreaking, EqualsARebuildAfterEveryJoint) {
  const Mesh mesh = irregular();
  CrackNetwork network(mesh);
  std::vector<Index> order(mesh.joint.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(GetParam()));
  std::set<Index> joints;
  std::set<Index> nodes;
  for (std::size_t i = 0; i < order.size(); ++i) {
    network.break_joints(mesh, std::span<const Index>(&order[i], 1));
    joints.insert(order[i]);
    const auto& ends = mesh.joint[at(order[i])].vertex;
    nodes.insert(ends.begin(), ends.end());
    CrackNetwork rebuilt(mesh);
    rebuilt.break_joints(mesh, std::span<const Index>(order).first(i + 1));
    ASSERT_EQ(network.broken_joints(), rebuilt.broken_joints());
    ASSERT_EQ(network.open_nodes(), rebuilt.open_nodes());
    ASSERT_TRUE(std::ranges::equal(network.broken_joints(), joints));
    ASSERT_TRUE(std::ranges::equal(network.open_nodes(), nodes));
    for (Index v = 0; v < mesh.vertices(); ++v) {
      ASSERT_EQ(network.is_open(v), nodes.contains(v));
    }
    ASSERT_TRUE(network.is_broken(order[i]));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomBreaking, testing::Range(1u, 4u));

}  // namespace
}  // namespace percolith::mesh
