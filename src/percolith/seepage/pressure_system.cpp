// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/pressure_system.hpp"

#include <algorithm>
#include <utility>

namespace percolith::seepage {
namespace {

std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

/// Inserts a number into a short ascending list that does not hold it yet.
void insert_once(std::vector<Index>& list, Index number) {
  auto place = list.end();
  while (place != list.begin() && *(place - 1) > number) {
    --place;
  }
  if (place == list.begin() || *(place - 1) != number) {
    list.insert(place, number);
  }
}

/// Pattern of the lower triangle: the diagonal, then for every column the distinct rows below it.
/// Returns where the off-diagonal term of every edge stands among the values, `none` where it has
/// no such term.
std::vector<Index> make_pattern(const FlowGraph& graph, const std::vector<Index>& node,
                                const std::vector<Index>& unknown, SymmetricMatrix& matrix) {
  std::vector<Index> slot(graph.from.size(), mesh::none);
  matrix.column_start.assign(node.size() + 1, 0);
  matrix.row.clear();
  matrix.row.reserve(node.size() + graph.from.size());
  std::vector<Index> rows;
  std::vector<std::pair<Index, Index>> below;  // edge, row
  for (std::size_t c = 0; c < node.size(); ++c) {
    const auto column = static_cast<Index>(c);
    rows.assign(1, column);
    below.clear();
    for (const Index entry : graph.incidence.row(node[c])) {
      const Index edge = entry / 2;
      const Index other = unknown[at(entry % 2 == 0 ? graph.to[at(edge)] : graph.from[at(edge)])];
      if (other > column) {
        below.emplace_back(edge, other);
        insert_once(rows, other);
      }
    }
    const auto start = static_cast<Index>(matrix.row.size());
    for (const auto& [edge, row] : below) {
      // Columns are short: a linear search beats bisection.
      slot[at(edge)] =
          start + static_cast<Index>(std::find(rows.begin(), rows.end(), row) - rows.begin());
    }
    matrix.row.insert(matrix.row.end(), rows.begin(), rows.end());
    matrix.column_start[c + 1] = static_cast<Index>(matrix.row.size());
  }
  matrix.value.assign(matrix.row.size(), 0.0);
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
  slot_ = make_pattern(graph, node_, unknown_, matrix_);
  right_hand_side_.resize(node_.size());
  solver_ = make_solver(matrix_.unknowns());
}

void PressureSystem::fill(const FlowGraph& graph, std::span<const double> conductance,
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
}

bool PressureSystem::assemble(const FlowGraph& graph, std::span<const double> conductance,
                              std::span<const double> storage_rate,
                              std::span<const std::uint8_t> held) {
  fill(graph, conductance, storage_rate, held);
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
