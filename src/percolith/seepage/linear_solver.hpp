// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/corner.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace percolith::seepage {

using mesh::Index;

/// A symmetric matrix by the columns of its lower triangle: rows ascend in each column, the
/// diagonal comes first.
struct SymmetricMatrix {
  std::vector<Index> column_start;  ///< unknowns + 1
  std::vector<Index> row;
  std::vector<double> value;
  [[nodiscard]] Index unknowns() const { return static_cast<Index>(column_start.size()) - 1; }
};

/// Solves symmetric positive definite systems with the same pattern again and again.
class LinearSolver {
public:
  virtual ~LinearSolver() = default;
  /// Prepares to solve with the present values of `matrix`, which must outlive the next solve;
  /// false when it is not positive definite. The pattern may change only after `reset`.
  [[nodiscard]] virtual bool factorize(const SymmetricMatrix& matrix) = 0;
  /// Overwrites the right-hand side by the solution; false when no solution was found. An iteration
  /// stops when the 2-norm of its residual is below `residual`; a factorisation does not look at
  /// it.
  [[nodiscard]] virtual bool solve(std::span<double> right_hand_side, double residual) = 0;
  /// Forgets the pattern.
  virtual void reset() = 0;
};

/// Sparse Cholesky factorisation (Eigen's SimplicialLDLT, approximate minimum degree ordering):
/// exact to round-off whatever the contrast of conductances.
[[nodiscard]] std::unique_ptr<LinearSolver> make_direct_solver();

/// Conjugate gradients with algebraic multigrid (hypre's BoomerAMG), for systems too large to
/// factorise; null when the program was built without hypre.
[[nodiscard]] std::unique_ptr<LinearSolver> make_multigrid_solver();

/// 2-norm of a vector.
[[nodiscard]] double norm(std::span<const double> vector);

/// The solver of choice for a number of unknowns.
[[nodiscard]] std::unique_ptr<LinearSolver> make_solver(Index unknowns);

}  // namespace percolith::seepage
