// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/execution.hpp"
#include "percolith/seepage/flow_graph.hpp"
#include "percolith/seepage/graph_conditions.hpp"

#include <optional>

namespace percolith::seepage {

/// A node of a part of the flow graph in which no pressure is given anywhere, so that steady
/// pressures there would be arbitrary; absent when every part has a datum. Seepage faces count.
[[nodiscard]] std::optional<Index> node_without_datum(const FlowGraph& graph,
                                                      const GraphConditions& conditions);

/// What a steady solution took.
struct SteadyResult {
  int iterations = 0;
  Index unknowns = 0;
  double throughput = 0.0;  ///< m2/s that enter and leave
  /// Flow, m2/s, that is round-off: a throughput not above it means water at rest.
  double round_off = 0.0;
};

/// Finds the steady pressures (theory.md section 6) under the conditions at the model's time, in
/// one solve, or iterated over the seepage faces; sets the state and `model.rate`. Throws
/// SolverError, with a place, where the flow would need suction below the cavitation pressure or no
/// solution is found.
SteadyResult solve_steady(Model& model, Execution& execution);

}  // namespace percolith::seepage
