// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/pressure_system.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace percolith::seepage {
namespace {

// By how much an iterative solver reduces the residual before the refinement, and in the end
// (docs/decisions/refinement.md).
constexpr double first_reduction = 1e-7;
constexpr double whole_reduction = 1e-15;

/// The off-diagonal terms of the edges, by column: row and edge number in one word, so that one
/// comparison orders them by row.
struct Terms {
  std::vector<Index> start;  // columns + 1
  std::vector<std::uint64_t> term;
};

Index row_of(std::uint64_t term) {
  return static_cast<Index>(term >> 32U);
}

Index edge_of(std::uint64_t term) {
  return static_cast<Index>(term & 0xffffffffU);
}

Terms terms_by_column(const FlowGraph& graph, const std::vector<Index>& unknown,
                      std::size_t columns) {
  Terms terms;
  terms.start.assign(columns + 1, 0);
  const auto visit = [&](const auto& add) {
    for (std::size_t e = 0; e < graph.from.size(); ++e) {
      const Index a = unknown[at(graph.from[e])];
      const Index b = unknown[at(graph.to[e])];
      if (std::min(a, b) != mesh::none && a != b) {
        add(at(std::min(a, b)), std::max(a, b), e);
      }
    }
  };
  visit([&](std::size_t column, Index, std::size_t) { ++terms.start[column + 1]; });
  std::partial_sum(terms.start.begin(), terms.start.end(), terms.start.begin());
  terms.term.resize(at(terms.start.back()));
  std::vector<Index> next(terms.start.begin(), terms.start.end() - 1);
  visit([&](std::size_t column, Index row, std::size_t edge) {
    terms.term[at(next[column]++)] = static_cast<std::uint64_t>(row) << 32U | edge;
  });
  return terms;
}

/// Pattern of the lower triangle: the diagonal, then for every column the distinct rows below it.
/// Returns where the off-diagonal term of every edge stands among the values, `none` where it has
/// no such term.
std::vector<Index> make_pattern(const FlowGraph& graph, const std::vector<Index>& unknown,
                                std::size_t unknowns, SymmetricMatrix& matrix) {
  Terms terms = terms_by_column(graph, unknown, unknowns);
  std::vector<Index> slot(graph.from.size(), mesh::none);
  matrix.column_start.assign(unknowns + 1, 0);
  matrix.row.clear();
  matrix.row.reserve(unknowns + terms.term.size());
  for (std::size_t c = 0; c < unknowns; ++c) {
    const auto first = terms.term.begin() + terms.start[c];
    const auto last = terms.term.begin() + terms.start[c + 1];
    std::sort(first, last);
    matrix.row.push_back(static_cast<Index>(c));
    for (auto term = first; term != last; ++term) {
      if (row_of(*term) != matrix.row.back()) {
        matrix.row.push_back(row_of(*term));
      }
      slot[at(edge_of(*term))] = static_cast<Index>(matrix.row.size()) - 1;
    }
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
  slot_ = make_pattern(graph, unknown_, node_.size(), matrix_);
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

/// The right-hand side becomes what the present pressures leave open at each node, m2/s.
void PressureSystem::set_residual(const FlowGraph& graph, std::span<const double> conductance,
                                  std::span<const double> storage_rate,
                                  std::span<const double> source, double reference_pressure,
                                  const GraphState& state) {
  edge_flows(graph, state, conductance, flow_);
  node_inflows(graph, flow_, inflow_);
  for (std::size_t u = 0; u < node_.size(); ++u) {
    const auto n = at(node_[u]);
    const double stored =
        storage_rate[n] * ((state.pressure[n] - reference_pressure) + state.change[n]);
    right_hand_side_[u] = held_[n] != 0 ? 0.0 : (source[n] - stored) + inflow_[n];
  }
}

bool PressureSystem::correct(double residual, GraphState& state) {
  if (!node_.empty() && !solver_->solve(right_hand_side_, residual)) {
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
  const auto set = [&] {
    set_residual(graph, conductance, storage_rate, source, reference_pressure, state);
  };
  set();
  const double start = norm(right_hand_side_);
  if (!correct(first_reduction * start, state)) {
    return false;
  }
  for (std::size_t n = 0; n < state.pressure.size(); ++n) {
    state.pressure[n] += state.change[n];
    state.change[n] = 0.0;
  }
  set();
  return correct(whole_reduction * start, state);
}

}  // namespace percolith::seepage
