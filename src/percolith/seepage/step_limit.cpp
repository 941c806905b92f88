// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/step_limit.hpp"

#include <algorithm>
#include <cmath>

namespace percolith::seepage {
namespace {

FlowLimit limit_of(const FlowGraph& graph, const char* mechanism, Index first, Index last) {
  std::vector<double> sum(graph.storage.size(), 0.0);
  for (Index e = first; e < last; ++e) {
    // Opposite an obtuse angle the conductance is negative; it counts by its size.
    const double conductance = std::abs(graph.conductance[at(e)]);
    sum[at(graph.from[at(e)])] += conductance;
    sum[at(graph.to[at(e)])] += conductance;
  }
  FlowLimit limit{mechanism};
  for (Index n = 0; n < graph.nodes(); ++n) {
    if (sum[at(n)] > 0.0 && graph.storage[at(n)] / sum[at(n)] < limit.step) {
      limit.step = graph.storage[at(n)] / sum[at(n)];
      limit.node = n;
    }
  }
  return limit;
}

}  // namespace

std::vector<FlowLimit> step_limits(const FlowGraph& graph) {
  std::vector<FlowLimit> limits;
  const auto add = [&](const char* mechanism, Index first, Index last) {
    FlowLimit limit = limit_of(graph, mechanism, first, last);
    if (limit.node != mesh::none) {
      limits.push_back(limit);
    }
  };
  add("pore flow", 0, graph.triangle_edges);
  add("finite joints", graph.triangle_edges, graph.joint_edges);
  add("crack flow", graph.joint_edges, graph.crack_edges);
  add("exchange", graph.crack_edges, graph.edges());
  std::sort(limits.begin(), limits.end(),
            [](const FlowLimit& a, const FlowLimit& b) { return a.step < b.step; });
  add("all together", 0, graph.edges());
  return limits;
}

}  // namespace percolith::seepage
