// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/linear_solver.hpp"

#if defined(PERCOLITH_HAVE_HYPRE)

#include <HYPRE.h>
#include <HYPRE_IJ_mv.h>
#include <HYPRE_parcsr_ls.h>
#include <mpi.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace percolith::seepage {
namespace {

constexpr int most_iterations = 500;
/// Below this share of the right-hand side round-off hides the residual.
constexpr double smallest_tolerance = 1e-14;

/// MPI and hypre want to be started once per process and ended at its exit.
void start_hypre() {
  int started = 0;
  MPI_Initialized(&started);
  if (started == 0) {
    // A process of its own needs no daemon of Open MPI, which takes long to start.
    setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
    MPI_Init(nullptr, nullptr);
    HYPRE_Init();
    std::atexit([] {
      HYPRE_Finalize();
      MPI_Finalize();
    });
  }
}

/// Rows of the whole matrix from the columns of its lower triangle.
struct Rows {
  std::vector<int> length;
  std::vector<HYPRE_BigInt> number;
  std::vector<HYPRE_BigInt> column;
  std::vector<double> value;
};

Rows whole_rows(const SymmetricMatrix& lower) {
  const auto n = at(lower.unknowns());
  Rows rows;
  rows.length.assign(n, 0);
  const auto visit = [&](const auto& add) {
    for (std::size_t c = 0; c < n; ++c) {
      for (auto k = at(lower.column_start[c]); k < at(lower.column_start[c + 1]); ++k) {
        const auto r = at(lower.row[k]);
        add(r, c, lower.value[k]);
        if (r != c) {
          add(c, r, lower.value[k]);
        }
      }
    }
  };
  visit([&](std::size_t r, std::size_t, double) { ++rows.length[r]; });
  std::vector<std::size_t> next(n + 1, 0);
  for (std::size_t r = 0; r < n; ++r) {
    next[r + 1] = next[r] + at(rows.length[r]);
  }
  rows.column.resize(next[n]);
  rows.value.resize(next[n]);
  visit([&](std::size_t r, std::size_t c, double value) {
    rows.column[next[r]] = static_cast<HYPRE_BigInt>(c);
    rows.value[next[r]++] = value;
  });
  rows.number.resize(n);
  std::iota(rows.number.begin(), rows.number.end(), HYPRE_BigInt{0});
  return rows;
}

/// A vector of hypre that is destroyed with its owner.
class Vector {
public:
  explicit Vector(HYPRE_BigInt n) {
    HYPRE_IJVectorCreate(MPI_COMM_SELF, 0, n - 1, &vector_);
    HYPRE_IJVectorSetObjectType(vector_, HYPRE_PARCSR);
    HYPRE_IJVectorInitialize(vector_);
  }
  ~Vector() { HYPRE_IJVectorDestroy(vector_); }
  Vector(const Vector&) = delete;
  Vector& operator=(const Vector&) = delete;

  void set(std::span<const HYPRE_BigInt> number, std::span<const double> value) {
    HYPRE_IJVectorSetValues(vector_, static_cast<HYPRE_Int>(value.size()), number.data(),
                            value.data());
    HYPRE_IJVectorAssemble(vector_);
  }
  void get(std::span<const HYPRE_BigInt> number, std::span<double> value) const {
    HYPRE_IJVectorGetValues(vector_, static_cast<HYPRE_Int>(value.size()), number.data(),
                            value.data());
  }
  [[nodiscard]] HYPRE_ParVector view() const {
    void* object = nullptr;
    HYPRE_IJVectorGetObject(vector_, &object);
    return static_cast<HYPRE_ParVector>(object);
  }

private:
  HYPRE_IJVector vector_ = nullptr;
};

class MultigridSolver : public LinearSolver {
public:
  MultigridSolver() { start_hypre(); }
  ~MultigridSolver() override { release(); }
  MultigridSolver(const MultigridSolver&) = delete;
  MultigridSolver& operator=(const MultigridSolver&) = delete;

  bool factorize(const SymmetricMatrix& lower) override {
    release();
    Rows rows = whole_rows(lower);
    const HYPRE_BigInt last = lower.unknowns() - 1;
    HYPRE_IJMatrixCreate(MPI_COMM_SELF, 0, last, 0, last, &matrix_);
    HYPRE_IJMatrixSetObjectType(matrix_, HYPRE_PARCSR);
    const std::vector<int> elsewhere(rows.length.size(), 0);  // on other processes
    HYPRE_IJMatrixSetDiagOffdSizes(matrix_, rows.length.data(), elsewhere.data());
    HYPRE_IJMatrixInitialize(matrix_);
    HYPRE_IJMatrixSetValues(matrix_, lower.unknowns(), rows.length.data(), rows.number.data(),
                            rows.column.data(), rows.value.data());
    HYPRE_IJMatrixAssemble(matrix_);
    number_ = std::move(rows.number);
    create_solvers();
    const auto n = static_cast<HYPRE_BigInt>(lower.unknowns());
    right_ = std::make_unique<Vector>(n);
    left_ = std::make_unique<Vector>(n);
    zero_.assign(at(lower.unknowns()), 0.0);
    right_->set(number_, zero_);
    left_->set(number_, zero_);
    return HYPRE_ParCSRPCGSetup(krylov_, view(), right_->view(), left_->view()) == 0;
  }

  bool solve(std::span<double> right_hand_side, double residual) override {
    const double start = norm(right_hand_side);
    if (start <= residual) {
      std::fill(right_hand_side.begin(), right_hand_side.end(), 0.0);
      return true;
    }
    const double tolerance = std::max(residual / start, smallest_tolerance);
    right_->set(number_, right_hand_side);
    left_->set(number_, zero_);
    HYPRE_PCGSetTol(krylov_, tolerance);
    HYPRE_ParCSRPCGSolve(krylov_, view(), right_->view(), left_->view());
    HYPRE_ClearAllErrors();
    double reached = 1.0;
    HYPRE_ParCSRPCGGetFinalRelativeResidualNorm(krylov_, &reached);
    left_->get(number_, right_hand_side);
    return reached <= tolerance;
  }

  void reset() override { release(); }

private:
  void create_solvers() {
    HYPRE_BoomerAMGCreate(&multigrid_);
    HYPRE_BoomerAMGSetPrintLevel(multigrid_, 0);
    HYPRE_BoomerAMGSetCoarsenType(multigrid_, 10);  // HMIS
    HYPRE_BoomerAMGSetInterpType(multigrid_, 17);   // extended+i by matrix products
    HYPRE_BoomerAMGSetPMaxElmts(multigrid_, 4);
    HYPRE_BoomerAMGSetStrongThreshold(multigrid_, 0.25);
    // Gauss-Seidel forwards on the way down and backwards on the way up is symmetric, as conjugate
    // gradients need it, at half the price of symmetric sweeps; the coarsest level is solved.
    HYPRE_BoomerAMGSetRelaxOrder(multigrid_, 0);
    HYPRE_BoomerAMGSetCycleRelaxType(multigrid_, 13, 1);
    HYPRE_BoomerAMGSetCycleRelaxType(multigrid_, 14, 2);
    HYPRE_BoomerAMGSetCycleRelaxType(multigrid_, 9, 3);
    HYPRE_BoomerAMGSetTol(multigrid_, 0.0);
    HYPRE_BoomerAMGSetMaxIter(multigrid_, 1);
    HYPRE_ParCSRPCGCreate(MPI_COMM_SELF, &krylov_);
    HYPRE_PCGSetMaxIter(krylov_, most_iterations);
    HYPRE_PCGSetTwoNorm(krylov_, 1);
    HYPRE_ParCSRPCGSetPrecond(krylov_, HYPRE_BoomerAMGSolve, HYPRE_BoomerAMGSetup, multigrid_);
  }

  [[nodiscard]] HYPRE_ParCSRMatrix view() const {
    void* object = nullptr;
    HYPRE_IJMatrixGetObject(matrix_, &object);
    return static_cast<HYPRE_ParCSRMatrix>(object);
  }

  void release() {
    if (krylov_ != nullptr) {
      HYPRE_ParCSRPCGDestroy(krylov_);
      HYPRE_BoomerAMGDestroy(multigrid_);
      HYPRE_IJMatrixDestroy(matrix_);
      krylov_ = nullptr;
    }
    right_.reset();
    left_.reset();
  }

  HYPRE_IJMatrix matrix_ = nullptr;
  HYPRE_Solver krylov_ = nullptr;
  HYPRE_Solver multigrid_ = nullptr;
  std::unique_ptr<Vector> right_, left_;
  std::vector<HYPRE_BigInt> number_;
  std::vector<double> zero_;
};

}  // namespace

std::unique_ptr<LinearSolver> make_multigrid_solver() {
  return std::make_unique<MultigridSolver>();
}

}  // namespace percolith::seepage

#else

namespace percolith::seepage {

std::unique_ptr<LinearSolver> make_multigrid_solver() {
  return nullptr;
}

}  // namespace percolith::seepage

#endif
