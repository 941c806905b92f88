// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/seepage/conditions.hpp"
#include "percolith/seepage/flow_graph.hpp"

#include <cstdint>
#include <vector>

namespace percolith::seepage {

/// A condition at a node of a flow graph.
struct GraphCondition {
  Index node = 0;
  Index vertex = 0;  ///< of the mesh
  NodeCondition condition;
};

/// The conditions of a model in the numbering of a graph; at most one prescribed pressure and at
/// most one seepage face per node, and no seepage face where the pressure is prescribed.
struct GraphConditions {
  std::vector<GraphCondition> pressure;
  std::vector<GraphCondition> rate;
  std::vector<GraphCondition> seepage_face;
  std::vector<std::uint8_t> prescribed;  ///< per node: 1 when its pressure is prescribed
};

/// Conditions at closed crack nodes are left out: they act once a crack opens there.
[[nodiscard]] GraphConditions make_graph_conditions(const Model& model, const FlowGraph& graph);
/// Those of the crack network alone, for the graph of `make_crack_graph`: the pores the cracks face
/// keep their pressure, without a condition.
[[nodiscard]] GraphConditions make_crack_conditions(const Model& model, const FlowGraph& graph);

}  // namespace percolith::seepage
