// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/seepage/flow_graph.hpp"
#include "percolith/seepage/linear_solver.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace percolith::seepage {

/// The linear equations for the pressures of a flow graph: for every node that is not prescribed
///   storage_rate (p - p_ref) - inflow(p) = source,
/// storage_rate = S/dt for a backward Euler step (theory.md section 6), zero in steady flow. The
/// matrix is symmetric positive definite; its pattern is made once.
class PressureSystem {
public:
  /// `prescribed` nodes (1 per node) never become unknowns.
  PressureSystem(const FlowGraph& graph, std::span<const std::uint8_t> prescribed);

  [[nodiscard]] Index unknowns() const { return matrix_.unknowns(); }
  [[nodiscard]] const SymmetricMatrix& matrix() const { return matrix_; }
  [[nodiscard]] bool is_unknown(Index node) const {
    return unknown_[static_cast<std::size_t>(node)] != mesh::none;
  }

  /// Fills in the matrix. `conductance` per edge (m2/(Pa s)); `storage_rate` per
  /// node (m2/(Pa s)); nodes with `held` set keep their pressure this time.
  void fill(const FlowGraph& graph, std::span<const double> conductance,
            std::span<const double> storage_rate, std::span<const std::uint8_t> held);
  /// Fills in the matrix and prepares the solver; false when it is not positive definite.
  [[nodiscard]] bool assemble(const FlowGraph& graph, std::span<const double> conductance,
                              std::span<const double> storage_rate,
                              std::span<const std::uint8_t> held);

  /// Solves for the pressures and refines them once, so that the flows balance to round-off even
  /// where neighbours differ by the last digits of a large pressure. An iterative solver does half
  /// of its work before and half after. Uses the matrix of the last `assemble`; `source` per node,
  /// m2/s.
  [[nodiscard]] bool solve(const FlowGraph& graph, std::span<const double> conductance,
                           std::span<const double> storage_rate, std::span<const double> source,
                           double reference_pressure, GraphState& state);

private:
  void set_residual(const FlowGraph& graph, std::span<const double> conductance,
                    std::span<const double> storage_rate, std::span<const double> source,
                    double reference_pressure, const GraphState& state);
  [[nodiscard]] bool correct(double residual, GraphState& state);

  SymmetricMatrix matrix_;
  std::vector<Index> unknown_;         // per node
  std::vector<Index> node_;            // per unknown
  std::vector<std::uint8_t> held_;     // per node
  std::vector<Index> slot_;            // per edge: its place among the values, or none
  std::vector<double> flow_, inflow_;  // work space
  std::vector<double> right_hand_side_;
  std::unique_ptr<LinearSolver> solver_;
};

}  // namespace percolith::seepage
