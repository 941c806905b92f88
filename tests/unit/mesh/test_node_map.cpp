// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/node_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include "unit/support/grid.hpp"
#include "unit/support/places.hpp"

namespace percolith::mesh {
namespace {

using test::at;

std::vector<std::uint8_t> all_tied(const Mesh& mesh) {
  return std::vector<std::uint8_t>(mesh.joint.size(), 1);
}

std::size_t nodes_at(const Mesh& mesh, const NodeMap& map, Index vertex) {
  std::set<Index> leaders;
  for (const Index c : mesh.vertex_corners.row(vertex)) {
    leaders.insert(map.leader(c));
  }
  return leaders.size();
}

/// Releases the joint between two places and returns whether either end changed.
bool release(const Mesh& mesh, std::vector<std::uint8_t>& tied, NodeMap& map, Point a, Point b) {
  const Index j = test::joint_between(mesh, a, b);
  tied[at(j)] = 0;
  bool changed = false;
  for (const Index v : mesh.joint[at(j)].vertex) {
    changed = map.refresh(mesh, tied, v) || changed;
  }
  return changed;
}

/// Nodes by a flood through tied joints over the whole mesh at once.
std::vector<Index> leaders_by_flood(const Mesh& mesh, const std::vector<std::uint8_t>& tied) {
  std::vector<Index> parent(at(mesh.corners()));
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](Index c) {
    while (parent[at(c)] != c) {
      c = parent[at(c)];
    }
    return c;
  };
  for (std::size_t j = 0; j < tied.size(); ++j) {
    for (std::size_t end = 0; tied[j] != 0 && end < 2; ++end) {
      const Index a = root(mesh.joint[j].corner[0][end]);
      const Index b = root(mesh.joint[j].corner[1][end]);
      parent[at(std::max(a, b))] = std::min(a, b);
    }
  }
  std::vector<Index> leaders;
  for (Index c = 0; c < mesh.corners(); ++c) {
    leaders.push_back(root(c));
  }
  return leaders;
}

TEST(NodeMap, TiedEverywhereIsOneNodeAVertex) {
  const Mesh mesh = build_mesh(test::make_grid({.columns = 5, .rows = 4, .jitter = 0.2}));
  const NodeMap map(mesh, all_tied(mesh));
  EXPECT_EQ(map.nodes(mesh).size(), mesh.vertex.size());
  for (Index v = 0; v < mesh.vertices(); ++v) {
    EXPECT_EQ(map.leader(mesh.vertex_corners.row(v).back()), mesh.vertex_corners.row(v).front());
    EXPECT_EQ(map.whole()[at(v)], 1);
  }
}

TEST(NodeMap, TiedNowhereIsOneNodeACorner) {
  const Mesh mesh = build_mesh(test::make_grid({.columns = 5, .rows = 4}));
  const NodeMap map(mesh, std::vector<std::uint8_t>(mesh.joint.size(), 0));
  EXPECT_EQ(map.nodes(mesh).size(), 3u * mesh.triangle_vertex.size());
  for (Index c = 0; c < mesh.corners(); ++c) {
    EXPECT_EQ(map.leader(c), c);
  }
}

TEST(NodeMap, TheFirstReleasedJointInsideIsATipAndSplitsNothing) {
  const Mesh mesh = build_mesh(test::make_grid({.columns = 4, .rows = 4}));
  auto tied = all_tied(mesh);
  NodeMap map(mesh, tied);
  EXPECT_FALSE(release(mesh, tied, map, {0.5, 0.25}, {0.5, 0.5}));
  EXPECT_EQ(map.nodes(mesh).size(), mesh.vertex.size());
  // The second at a vertex splits it, and only it.
  EXPECT_TRUE(release(mesh, tied, map, {0.5, 0.5}, {0.5, 0.75}));
  EXPECT_EQ(nodes_at(mesh, map, test::vertex_at(mesh, {0.5, 0.5})), 2u);
  EXPECT_EQ(nodes_at(mesh, map, test::vertex_at(mesh, {0.5, 0.25})), 1u);
  EXPECT_EQ(nodes_at(mesh, map, test::vertex_at(mesh, {0.5, 0.75})), 1u);
  EXPECT_EQ(map.nodes(mesh).size(), mesh.vertex.size() + 1);
  EXPECT_EQ(map.whole()[at(test::vertex_at(mesh, {0.5, 0.5}))], 0);
  // Each half is on one side of the crack.
  for (const Index c : mesh.vertex_corners.row(test::vertex_at(mesh, {0.5, 0.5}))) {
    const Index leader = map.leader(c);
    EXPECT_EQ(test::centroid(mesh, triangle_of(c)).x < 0.5,
              test::centroid(mesh, triangle_of(leader)).x < 0.5);
  }
  // A third joint there makes three.
  EXPECT_TRUE(release(mesh, tied, map, {0.5, 0.5}, {0.75, 0.5}));
  EXPECT_EQ(nodes_at(mesh, map, test::vertex_at(mesh, {0.5, 0.5})), 3u);
}

TEST(NodeMap, AtABoundaryVertexTheFirstReleasedJointSplits) {
  const Mesh mesh = build_mesh(test::make_grid({.columns = 4, .rows = 4}));
  auto tied = all_tied(mesh);
  NodeMap map(mesh, tied);
  EXPECT_TRUE(release(mesh, tied, map, {0.5, 0.0}, {0.5, 0.25}));
  EXPECT_EQ(nodes_at(mesh, map, test::vertex_at(mesh, {0.5, 0.0})), 2u);
  EXPECT_EQ(nodes_at(mesh, map, test::vertex_at(mesh, {0.5, 0.25})), 1u);
}

TEST(NodeMap, VisitsTheCornersOfANodeInOrder) {
  const Mesh mesh = build_mesh(test::make_grid({.columns = 4, .rows = 4}));
  auto tied = all_tied(mesh);
  NodeMap map(mesh, tied);
  release(mesh, tied, map, {0.5, 0.0}, {0.5, 0.25});
  std::size_t seen = 0;
  for (const Index node : map.nodes(mesh)) {
    Index before = none;
    map.for_each_corner(mesh, node, [&](Index c) {
      EXPECT_GT(c, before);
      EXPECT_EQ(map.leader(c), node);
      before = c;
      ++seen;
    });
  }
  EXPECT_EQ(seen, 3u * mesh.triangle_vertex.size());
}

class RandomRelease : public testing::TestWithParam<unsigned> {};

TEST_P(RandomRelease, EqualsARebuildAfterEveryJoint) {
  const Mesh mesh = build_mesh(test::shuffled(
      test::make_grid({.columns = 9, .rows = 8, .jitter = 0.3, .mixed_diagonals = true}),
      GetParam()));
  auto tied = all_tied(mesh);
  NodeMap map(mesh, tied);
  std::vector<Index> order(mesh.joint.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(GetParam()));
  for (const Index j : order) {
    tied[at(j)] = 0;
    for (const Index v : mesh.joint[at(j)].vertex) {
      const auto before = nodes_at(mesh, map, v);
      const bool changed = map.refresh(mesh, tied, v);
      EXPECT_EQ(changed, nodes_at(mesh, map, v) != before);
    }
    const NodeMap rebuilt(mesh, tied);
    ASSERT_TRUE(std::ranges::equal(map.leaders(), rebuilt.leaders()));
    ASSERT_TRUE(std::ranges::equal(map.whole(), rebuilt.whole()));
    ASSERT_TRUE(std::ranges::equal(map.leaders(), leaders_by_flood(mesh, tied)));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomRelease, testing::Range(1u, 7u));

}  // namespace
}  // namespace percolith::mesh
