// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/pressure_system.hpp"

#include <algorithm>
#include <numeric>

namespace percolith::seepage {
namespace {

std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

/// Pattern of the lower triangle: the diagonal, then for every column the distinct rows below it.
void make_pattern(const FlowGraph& graph, const std::vector<Index>& node,
                  const std::vector<Index>& unknown, SymmetricMatrix& matrix) {
  const auto unknowns = node.size();
  matrix.column_start.assign(unknowns + 1, 0);
  matrix.row.clear();
  matrix.row.reserve(unknowns + graph.from.size());
  std::vector<Index> rows;
  for (std::size_t column = 0; column < unknowns; ++column) {
    rows.assign(1, static_cast<Index>(column));
    for (const Index entry : graph.incidence.row(node[column])) {
      const auto edge = at(entry / 2);
      const Index other = entry % 2 == 0 ? graph.to[edge] : graph.from[edge];
      if (unknown[at(other)] > static_cast<Index>(column)) {
        rows.push_back(unknown[at(other)]);
      }
    }
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    matrix.row.insert(matrix.row.end(), rows.begin(), rows.end());
    matrix.column_start[column + 1] = static_cast<Index>(matrix.row.size());
  }
  matrix.value.assign(matrix.row.size(), 0.0);
}

/// Where the off-diagonal term of every edge stands among the values.
std::vector<Index> edge_slots(const FlowGraph& graph, const std::vector<Index>& unknown,
                              const SymmetricMatrix& matrix) {
  std::vector<Index> slot(graph.from.size(), mesh::none);
  for (std::size_t e = 0; e < slot.size(); ++e) {
    const Index a = unknown[at(graph.from[e])];
    const Index b = unknown[at(graph.to[e])];
    if (a == mesh::none || b == mesh::none || a == b) {
      continue;
    }
    const auto column = at(std::min(a, b));
    const auto first = matrix.row.begin() + matrix.column_start[column];
    const auto last = matrix.row.begin() + matrix.column_start[column + 1];
    // Columns are short: a linear search beats bisection.
    slot[e] = static_cast<Index>(std::find(first, last, std::max(a, b)) - matrix.row.begin());
  }
  return slot;
}

}  // namespace

PressureSystem::PressureSystem(const FlowGraph& graph, std::span<const std::uint8_t> prescribed)
    : unknown_(at(graph.nodes()), mesh::none), held_(at(graph.nodes()), 0),
      flow_(graph.from.size()), inflow_(at(graph.nodes())) {
  for (Index n = 0; n < graph.nodes(); ++n) {
    if (prescribed[at(n)] == 0) {
      unknown_[at(n)] = static_cast<Index>(node_.size());
      node_.push_back(n);
    }
  }
  make_pattern(graph, node_, unknown_, matrix_);
  slot_ = edge_slots(graph, unknown_, matrix_);
  right_hand_side_.resize(node_.size());
  solver_ = make_solver(matrix_.unknowns());
}

bool PressureSystem::assemble(const FlowGraph& graph, std::span<const double> conductance,
                              std::span<const double> storage_rate,
                              std::span<const std::uint8_t> held) {
  std::copy(held.begin(), held.end(), held_.begin());
  std::fill(matrix_.value.begin(), matrix_.value.end(), 0.0);
  const auto diagonal = [&](Index node) -> double& {
    return matrix_.value[at(matrix_.column_start[at(unknown_[at(node)])])];
  };
  const auto is_free = [&](Index node) { return is_unknown(node) && held_[at(node)] == 0; };
  for (const Index n : node_) {
    diagonal(n) = held_[at(n)] != 0 ? 1.0 : storage_rate[at(n)];
  }
  for (Index e = 0; e < graph.edges(); ++e) {
    const Index a = graph.from[at(e)];
    const Index b = graph.to[at(e)];
    const bool free_a = is_free(a);
    const bool free_b = is_free(b);
    if (free_a) {
      diagonal(a) += conductance[at(e)];
    }
    if (free_b) {
      diagonal(b) += conductance[at(e)];
    }
    if (free_a && free_b) {
      matrix_.value[at(slot_[at(e)])] -= conductance[at(e)];
    }
  }
  return node_.empty() || solver_->factorize(matrix_);
}

bool PressureSystem::correct(const FlowGraph& graph, std::span<const double> conductance,
                             std::span<const double> storage_rate, std::span<const double> source,
                             double reference_pressure, GraphState& state) {
  edge_flows(graph, state, conductance, flow_);
  node_inflows(graph, flow_, inflow_);
  for (std::size_t u = 0; u < node_.size(); ++u) {
    const auto n = at(node_[u]);
    const double stored =
        storage_rate[n] * ((state.pressure[n] - reference_pressure) + state.change[n]);
    right_hand_side_[u] = held_[n] != 0 ? 0.0 : (source[n] - stored) + inflow_[n];
  }
  if (!node_.empty() && !solver_->solve(right_hand_side_)) {
    return false;
  }
  for (std::size_t u = 0; u < node_.size(); ++u) {
    state.change[at(node_[u])] += right_hand_side_[u];
  }
  return true;
}

bool PressureSystem::solve(const FlowGraph& graph, std::span<const double> conductance,
                           std::span<const double> storage_rate, std::span<const double> source,
                           double reference_pressure, GraphState& state) {
  if (!correct(graph, conductance, storage_rate, source, reference_pressure, state)) {
    return false;
  }
  for (std::size_t n = 0; n < state.pressure.size(); ++n) {
    state.pressure[n] += state.change[n];
    state.change[n] = 0.0;
  }
  return correct(graph, conductance, storage_rate, source, reference_pressure, state);
}

}  // namespace percolith::seepage
