// SPDX-License-Identifier: BSD-3-Clause
#include "bench/support/steady_comparison.hpp"

#include "percolith/seepage/graph_conditions.hpp"
#include "percolith/seepage/pressure_system.hpp"
#include "percolith/seepage/steady_flow.hpp"

#include <fmt/format.h>

#include <map>

#include "bench/support/measure.hpp"

namespace percolith::bench {
namespace {

constexpr double limit = 1.3;

/// The equations `solve_steady` solves for a model: a pressure of zero everywhere but where it is
/// given makes the inflows the right-hand side.
struct Equations {
  seepage::SymmetricMatrix matrix;
  std::vector<double> right_hand_side;
};

Equations equations_of(const seepage::Model& model) {
  const seepage::FlowGraph graph = seepage::make_flow_graph(model);
  const seepage::GraphConditions conditions = seepage::make_graph_conditions(model, graph);
  seepage::PressureSystem system(graph, conditions.prescribed);
  const std::vector<double> storage_rate(static_cast<std::size_t>(graph.nodes()), 0.0);
  const std::vector<std::uint8_t> held(storage_rate.size(), 0);
  system.fill(graph, graph.conductance, storage_rate, held);
  seepage::GraphState state = seepage::gather_state(model, graph);
  for (const seepage::GraphCondition& c : conditions.pressure) {
    state.pressure[static_cast<std::size_t>(c.node)] = model.conditions.value(c.condition, 0.0);
  }
  std::vector<double> flow(graph.from.size());
  std::vector<double> inflow(storage_rate.size());
  seepage::edge_flows(graph, state, graph.conductance, flow);
  seepage::node_inflows(graph, flow, inflow);
  Equations equations{system.matrix(), {}};
  for (mesh::Index n = 0; n < graph.nodes(); ++n) {
    if (system.is_unknown(n)) {
      equations.right_hand_side.push_back(inflow[static_cast<std::size_t>(n)]);
    }
  }
  return equations;
}

}  // namespace

void compare_steady(const std::string& name, const mesh::Mesh& mesh, const FlowCase& flow,
                    BareSolver bare, int rounds, Results& results) {
  const seepage::Model start = make_flow_model(mesh, flow);
  const Equations equations = equations_of(start);
  Best ours;
  Best theirs;
  std::map<std::string, Best> part;
  seepage::SteadyResult found;
  for (int round = 0; round < rounds; ++round) {
    seepage::Model model = start;
    Execution execution;
    const ProcessorClock our_clock;
    found = seepage::solve_steady(model, execution);
    ours.add(our_clock.seconds());
    for (const auto& [phase, seconds] : execution.wall_time()) {
      part[phase].add(seconds);
    }
    std::vector<double> solution = equations.right_hand_side;
    theirs.add(bare(equations.matrix, solution));
  }
  const double ratio = ours.value() / theirs.value();
  fmt::print("\n{}: {} triangles, {} unknowns, {} entries\n", name, mesh.triangles(),
             found.unknowns, equations.matrix.row.size());
  fmt::print("  steady field {:.3f} s, bare solver {:.3f} s, ratio {:.2f} (at most {})\n",
             ours.value(), theirs.value(), ratio, limit);
  for (const auto& [phase, seconds] : part) {
    fmt::print("  {:<16}{:>8.3f} s\n", phase, seconds.value());
  }
  results.report(name + ".time", ours.value(), "s");
  results.report(name + ".bare_time", theirs.value(), "s");
  results.at_most(name + ".ratio_to_bare_solver", ratio, "1", limit);
}

}  // namespace percolith::bench
