// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/node_blocks.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "unit/support/flow_model.hpp"

namespace percolith::seepage {
namespace {

using test::at;

/// A grid with a crack that splits some of its nodes.
Model cracked_grid() {
  const test::Grid grid{.columns = 9, .rows = 7};
  auto file = test::make_grid(grid);
  test::add_column_curve(grid, file, "upright", 4, 1, 5);
  test::FlowOptions options;
  options.fracture = {{.initial_aperture = 1e-5, .transmissivity = {}, .exchange = 2e-9}};
  Model model = test::make_flow(file, options);
  test::break_curve(model, "upright", 0);
  return model;
}

TEST(NodeBlocks, HoldEveryVertexOnceWithAllItsCornersInOrder) {
  const Model model = cracked_grid();
  const NodeBlocks blocks = node_blocks(model);
  ASSERT_GT(blocks.nodes(), 0);
  std::vector<int> met(at(model.mesh.vertices()), 0);
  for (Index n = 0; n < blocks.nodes(); ++n) {
    const Index block = n / block_width;
    std::vector<Index> corners;
    for (Index e = blocks.start[at(block)] + n % block_width; e < blocks.start[at(block) + 1];
         e += block_width) {
      corners.push_back(blocks.corner[at(e)]);
      EXPECT_EQ(blocks.triangle[at(e)], mesh::triangle_of(blocks.corner[at(e)]));
    }
    const Index vertex = model.mesh.vertex_of(corners.front());
    const auto row = model.mesh.vertex_corners.row(vertex);
    EXPECT_EQ(corners, std::vector<Index>(row.begin(), row.end()));
    EXPECT_EQ(model.pore_nodes.whole()[at(vertex)], 1);
    EXPECT_EQ(blocks.storage[at(n)], model.state.storage[at(corners.front())]);
    EXPECT_EQ(blocks.void_volume[at(n)], model.state.void_volume[at(corners.front())]);
    ++met[at(vertex)];
  }
  int split = 0;
  for (const Index vertex : blocks.single) {
    split += model.pore_nodes.whole()[at(vertex)] == 0 ? 1 : 0;
    ++met[at(vertex)];
  }
  EXPECT_GT(split, 0);
  EXPECT_EQ(met, std::vector<int>(met.size(), 1));
}

}  // namespace
}  // namespace percolith::seepage
