// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/seepage/flow_graph.hpp"

#include <limits>
#include <string>
#include <vector>

namespace percolith::seepage {

/// The largest stable explicit step one mechanism allows, and where.
struct FlowLimit {
  std::string
      mechanism;  ///< "pore flow", "finite joints", "crack flow", "exchange", "all together"
  double step = std::numeric_limits<double>::infinity();  ///< s
  Index node = mesh::none;
};

/// Limits of the explicit scheme (theory.md section 6): storage over the sum of conductances at
/// each node, the smallest over the nodes, for every mechanism that is there, smallest first; the
/// last entry counts all together and is the one that holds.
[[nodiscard]] std::vector<FlowLimit> step_limits(const FlowGraph& graph);

}  // namespace percolith::seepage
