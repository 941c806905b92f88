// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/steady_flow.hpp"

#include "percolith/core/error.hpp"
#include "percolith/seepage/account.hpp"
#include "percolith/seepage/active_set.hpp"
#include "percolith/seepage/pressure_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace percolith::seepage {
namespace {

std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

constexpr int most_iterations = 200;

void refuse_suction(const Model& model, const FlowGraph& graph, const GraphState& state) {
  if (!model.can_empty()) {
    return;
  }
  const double limit = model.reference_pressure();
  const auto lowest = std::min_element(state.pressure.begin(), state.pressure.end());
  if (*lowest < limit - pressure_tolerance(state, limit)) {
    const auto node = static_cast<Index>(lowest - state.pressure.begin());
    const Point p = graph.place(model, node);
    throw SolverError(fmt::format(
        "steady flow needs a pressure of {:.6g} Pa at the {} at ({:.6g}, {:.6g}), below the "
        "cavitation pressure of {:.6g} Pa: the rock would drain there. Use time.scheme = "
        "\"implicit\" and run until nothing changes, or set fluid.cavitation_pressure = \"-inf\" "
        "to "
        "keep it saturated under suction",
        *lowest, graph.kind(node), p.x, p.y, limit));
  }
}

void book_rates(Model& model, const GraphConditions& conditions, const ActiveSet& active,
                std::span<const double> inflow, std::span<const double> rate) {
  std::vector<Booking> bookings;
  const auto supply = [&](const GraphCondition& c) {
    bookings.push_back({c.condition.condition, c.vertex, -inflow[at(c.node)] - rate[at(c.node)]});
  };
  for (const GraphCondition& c : conditions.pressure) {
    supply(c);
  }
  for (const GraphCondition& c : conditions.seepage_face) {
    if (active.is_open_face(c.node)) {
      supply(c);
    }
  }
  for (const GraphCondition& c : conditions.rate) {
    bookings.push_back(
        {c.condition.condition, c.vertex, model.conditions.value(c.condition, model.state.time)});
  }
  book_steady(model, bookings);
}

}  // namespace

std::optional<Index> node_without_datum(const FlowGraph& graph, const GraphConditions& conditions) {
  std::vector<Index> parent(at(graph.nodes()));
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](Index n) {
    while (parent[at(n)] != n) {
      parent[at(n)] = parent[at(parent[at(n)])];
      n = parent[at(n)];
    }
    return n;
  };
  for (Index e = 0; e < graph.edges(); ++e) {
    if (graph.conductance[at(e)] != 0.0) {
      const Index a = root(graph.from[at(e)]);
      const Index b = root(graph.to[at(e)]);
      parent[at(std::max(a, b))] = std::min(a, b);
    }
  }
  std::vector<std::uint8_t> has_datum(parent.size(), 0);
  for (const GraphCondition& c : conditions.pressure) {
    has_datum[at(root(c.node))] = 1;
  }
  for (const GraphCondition& c : conditions.seepage_face) {
    has_datum[at(root(c.node))] = 1;
  }
  for (Index n = 0; n < graph.nodes(); ++n) {
    if (has_datum[at(root(n))] == 0) {
      return n;
    }
  }
  return std::nullopt;
}

SteadyResult solve_steady(Model& model, Execution& execution) {
  auto start = std::chrono::steady_clock::now();
  const FlowGraph graph = make_flow_graph(model);
  const GraphConditions conditions = make_graph_conditions(model, graph);
  PressureSystem system(graph, conditions.prescribed);
  ActiveSet active(graph);
  GraphState state = gather_state(model, graph);
  const std::vector<double> no_storage(state.pressure.size(), 0.0);
  std::vector<double> rate(state.pressure.size(), 0.0);
  std::vector<double> flow(graph.from.size());
  std::vector<double> inflow(state.pressure.size());
  for (const GraphCondition& c : conditions.rate) {
    rate[at(c.node)] += model.conditions.value(c.condition, model.state.time);
  }
  for (const GraphCondition& c : conditions.pressure) {
    state.pressure[at(c.node)] = model.conditions.value(c.condition, model.state.time);
  }
  execution.book("assembly", start);
  SteadyResult result{0, system.unknowns(), 0.0};
  // Faces start open: a system without any given pressure would be singular.
  bool changed = active.open_faces(conditions);
  do {
    start = std::chrono::steady_clock::now();
    active.hold(model, conditions, model.state.time, state);
    if (!system.assemble(graph, graph.conductance, no_storage, active.held())) {
      throw SolverError("steady flow: the equations are singular; every seepage face closed, or a "
                        "part of the model has no conductance to a given pressure");
    }
    execution.book("factorisation", start);
    start = std::chrono::steady_clock::now();
    if (!system.solve(graph, graph.conductance, no_storage, rate, model.reference_pressure(),
                      state)) {
      throw SolverError("steady flow: the linear solver found no solution; check permeabilities "
                        "and transmissivities for extreme ratios");
    }
    edge_flows(graph, state, graph.conductance, flow);
    node_inflows(graph, flow, inflow);
    execution.book("solution", start);
    changed =
        active.update_faces(model, conditions, model.state.time, rate, no_storage, inflow, state);
  } while (++result.iterations < most_iterations && changed);
  if (changed) {
    throw SolverError(fmt::format("steady flow: the seepage faces did not settle in {} iterations",
                                  most_iterations));
  }
  refuse_suction(model, graph, state);
  book_rates(model, conditions, active, inflow, rate);
  result.throughput = model.rate_in;
  std::vector<CompensatedSum> content(state.pressure.size());
  for (std::size_t n = 0; n < content.size(); ++n) {
    content[n].value = graph.storage[n] * (state.pressure[n] - model.reference_pressure());
  }
  scatter_contents(model, graph, content);
  return result;
}

}  // namespace percolith::seepage
