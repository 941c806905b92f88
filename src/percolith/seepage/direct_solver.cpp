// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/linear_solver.hpp"

#include <Eigen/SparseCholesky>

#include <cmath>
#include <numeric>

namespace percolith::seepage {
namespace {

class DirectSolver : public LinearSolver {
public:
  bool factorize(const SymmetricMatrix& matrix) override {
    const Eigen::Map<const Eigen::SparseMatrix<double, Eigen::ColMajor, Index>> view(
        matrix.unknowns(), matrix.unknowns(), static_cast<Index>(matrix.row.size()),
        matrix.column_start.data(), matrix.row.data(), matrix.value.data());
    if (analysed_) {
      factor_.factorize(view);
    } else {
      // In one call, which reorders the matrix once instead of twice.
      factor_.compute(view);
      analysed_ = true;
    }
    return factor_.info() == Eigen::Success && (factor_.vectorD().array() > 0.0).all();
  }

  bool solve(std::span<double> right_hand_side, double /*residual*/) override {
    Eigen::Map<Eigen::VectorXd> b(right_hand_side.data(),
                                  static_cast<Eigen::Index>(right_hand_side.size()));
    b = factor_.solve(b).eval();
    return b.allFinite();
  }

  void reset() override { analysed_ = false; }

private:
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double, Eigen::ColMajor, Index>, Eigen::Lower> factor_;
  bool analysed_ = false;
};

}  // namespace

std::unique_ptr<LinearSolver> make_direct_solver() {
  return std::make_unique<DirectSolver>();
}

double norm(std::span<const double> vector) {
  return std::sqrt(std::inner_product(vector.begin(), vector.end(), vector.begin(), 0.0));
}

std::unique_ptr<LinearSolver> make_solver(Index unknowns) {
  // Above this the factorisation costs more time and memory than multigrid (docs/performance.md).
  constexpr Index largest_direct = 300'000;
  if (unknowns > largest_direct) {
    if (auto solver = make_multigrid_solver()) {
      return solver;
    }
  }
  return make_direct_solver();
}

}  // namespace percolith::seepage
