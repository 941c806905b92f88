// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/steady_flow.hpp"

#include "percolith/core/error.hpp"
#include "percolith/seepage/account.hpp"
#include "percolith/seepage/active_set.hpp"
#include "percolith/seepage/pressure_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace percolith::seepage {
namespace {

constexpr int most_rounds = 200;

void refuse_suction(const Model& model, const FlowGraph& graph, const GraphState& state,
                    std::string_view way_out) {
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
        "cavitation pressure of {:.6g} Pa: the rock would drain there. {}",
        *lowest, graph.kind(node), p.x, p.y, limit, way_out));
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

/// Flow that the last digit of the largest pressure drives through all conductances, m2/s.
double round_off_flow(const FlowGraph& graph, const GraphState& state) {
  double largest = 0.0;
  for (std::size_t n = 0; n < state.pressure.size(); ++n) {
    largest = std::max({largest, std::abs(state.pressure[n]), std::abs(graph.lift[n])});
  }
  double sum = 0.0;
  for (const double conductance : graph.conductance) {
    sum += std::abs(conductance);
  }
  return std::numeric_limits<double>::epsilon() * largest * sum;
}

/// The arrays of a steady solution.
struct SteadyFields {
  GraphState state;
  std::vector<double> no_storage, rate, flow, inflow;
};

/// Pressures to start from do not depend on the state before, so neither does the result.
SteadyFields prepare(const Model& model, const FlowGraph& graph,
                     const GraphConditions& conditions) {
  const auto nodes = at(graph.nodes());
  SteadyFields fields{gather_state(model, graph), std::vector<double>(nodes, 0.0),
                      std::vector<double>(nodes, 0.0), std::vector<double>(graph.from.size()),
                      std::vector<double>(nodes)};
  std::fill(fields.state.pressure.begin(), fields.state.pressure.end(), model.reference_pressure());
  for (const GraphCondition& c : conditions.rate) {
    fields.rate[at(c.node)] += model.conditions.value(c.condition, model.state.time);
  }
  for (const GraphCondition& c : conditions.pressure) {
    fields.state.pressure[at(c.node)] = model.conditions.value(c.condition, model.state.time);
  }
  return fields;
}

/// Solves with the present set of open faces; throws SolverError where there is no solution.
void solve_once(const Model& model, const FlowGraph& graph, PressureSystem& system,
                const ActiveSet& active, SteadyFields& fields, Execution& execution) {
  auto start = std::chrono::steady_clock::now();
  if (!system.assemble(graph, graph.conductance, fields.no_storage, active.held())) {
    throw SolverError("steady flow: the equations are singular; every seepage face closed, or a "
                      "part of the model has no conductance to a given pressure");
  }
  execution.book("factorisation", start);
  start = std::chrono::steady_clock::now();
  if (!system.solve(graph, graph.conductance, fields.no_storage, fields.rate,
                    model.reference_pressure(), fields.state)) {
    throw SolverError("steady flow: the linear solver found no solution; check permeabilities "
                      "and transmissivities for extreme ratios");
  }
  edge_flows(graph, fields.state, graph.conductance, fields.flow);
  node_inflows(graph, fields.flow, fields.inflow);
  execution.book("solution", start);
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

SteadyResult solve_steady(Model& model, Execution& execution, std::string_view way_out) {
  const auto start = std::chrono::steady_clock::now();
  const FlowGraph graph = make_flow_graph(model);
  const GraphConditions conditions = make_graph_conditions(model, graph);
  PressureSystem system(graph, conditions.prescribed);
  ActiveSet active(graph);
  SteadyFields fields = prepare(model, graph, conditions);
  execution.book("assembly", start);
  SteadyResult result{0, system.unknowns(), 0.0, 0.0};
  // Faces start open: a system without any given pressure would be singular.
  bool changed = active.open_faces(conditions);
  do {
    active.hold(model, conditions, model.state.time, fields.state);
    solve_once(model, graph, system, active, fields, execution);
    changed = active.update_faces(model, conditions, model.state.time, fields.rate,
                                  fields.no_storage, fields.inflow, fields.state);
  } while (++result.iterations < most_rounds && changed);
  if (changed) {
    throw SolverError(
        fmt::format("steady flow: the seepage faces did not settle in {} iterations", most_rounds));
  }
  refuse_suction(model, graph, fields.state, way_out);
  book_rates(model, conditions, active, fields.inflow, fields.rate);
  result.throughput = model.rate_in;
  result.round_off = round_off_flow(graph, fields.state);
  std::vector<CompensatedSum> content(fields.state.pressure.size());
  for (std::size_t n = 0; n < content.size(); ++n) {
    content[n].value = graph.storage[n] * (fields.state.pressure[n] - model.reference_pressure());
  }
  scatter_contents(model, graph, content);
  return result;
}

}  // namespace percolith::seepage
