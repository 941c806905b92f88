// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/execution.hpp"
#include "percolith/seepage/flow_graph.hpp"
#include "percolith/seepage/graph_conditions.hpp"

#include <optional>
#include <string_view>

namespace percolith::seepage {

/// A node of a part of the flow graph in which no pressure is given anywhere, so that steady
/// pressures there would be arbitrary; absent when every part has a datum. Seepage faces count.
[[nodiscard]] std::optional<Index> node_without_datum(const FlowGraph& graph,
                                                      const GraphConditions& conditions);

/// What helps in rock at rest where steady flow would need more suction than there is.
inline constexpr std::string_view ways_out_of_suction =
    "Use time.scheme = \"implicit\" with time.stop_ratio, such as 1e-3, which ends the run once "
    "the "
    "flow is steady, or set fluid.cavitation_pressure = \"-inf\" to keep it saturated under "
    "suction";

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
/// SolverError, with a place, where the flow would need suction below the cavitation pressure, with
/// `way_out` as what to do then, or no solution is found.
SteadyResult solve_steady(Model& model, Execution& execution,
                          std::string_view way_out = ways_out_of_suction);

}  // namespace percolith::seepage
