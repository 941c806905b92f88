// SPDX-License-Identifier: BSD-3-Clause
// A steady field on 1e6 triangles against BoomerAMG + CG alone on the same equations, with the same
// options and the same reduction of the residual. Needs hypre.
#include <fmt/format.h>

#include "bench/support/measure.hpp"
#include "bench/support/steady_comparison.hpp"

#if defined(PERCOLITH_HAVE_HYPRE)

#include <HYPRE.h>
#include <HYPRE_IJ_mv.h>
#include <HYPRE_parcsr_ls.h>
#include <mpi.h>

#include <numeric>
#include <stdexcept>

namespace {

using namespace percolith;
using namespace percolith::bench;

constexpr double reduction = 1e-15;

/// Both triangles of the matrix, row by row.
struct Rows {
  std::vector<int> number, length, column;
  std::vector<double> value;
};

Rows rows_of(const seepage::SymmetricMatrix& matrix) {
  const auto n = static_cast<std::size_t>(matrix.unknowns());
  std::vector<std::vector<std::pair<int, double>>> row(n);
  for (std::size_t c = 0; c < n; ++c) {
    for (auto k = static_cast<std::size_t>(matrix.column_start[c]);
         k < static_cast<std::size_t>(matrix.column_start[c + 1]); ++k) {
      const auto r = static_cast<std::size_t>(matrix.row[k]);
      row[r].emplace_back(static_cast<int>(c), matrix.value[k]);
      if (r != c) {
        row[c].emplace_back(matrix.row[k], matrix.value[k]);
      }
    }
  }
  Rows rows;
  rows.number.resize(n);
  std::iota(rows.number.begin(), rows.number.end(), 0);
  for (const auto& entries : row) {
    rows.length.push_back(static_cast<int>(entries.size()));
    for (const auto& [column, value] : entries) {
      rows.column.push_back(column);
      rows.value.push_back(value);
    }
  }
  return rows;
}

HYPRE_IJVector make_vector(const Rows& rows, const std::vector<double>& value) {
  const int n = static_cast<int>(value.size());
  HYPRE_IJVector vector = nullptr;
  HYPRE_IJVectorCreate(MPI_COMM_SELF, 0, n - 1, &vector);
  HYPRE_IJVectorSetObjectType(vector, HYPRE_PARCSR);
  HYPRE_IJVectorInitialize(vector);
  HYPRE_IJVectorSetValues(vector, n, rows.number.data(), value.data());
  HYPRE_IJVectorAssemble(vector);
  return vector;
}

HYPRE_IJMatrix make_matrix(const Rows& rows) {
  const int n = static_cast<int>(rows.number.size());
  const std::vector<int> elsewhere(rows.number.size(), 0);
  HYPRE_IJMatrix matrix = nullptr;
  HYPRE_IJMatrixCreate(MPI_COMM_SELF, 0, n - 1, 0, n - 1, &matrix);
  HYPRE_IJMatrixSetObjectType(matrix, HYPRE_PARCSR);
  HYPRE_IJMatrixSetDiagOffdSizes(matrix, rows.length.data(), elsewhere.data());
  HYPRE_IJMatrixInitialize(matrix);
  std::vector<int> length = rows.length;
  HYPRE_IJMatrixSetValues(matrix, n, length.data(), rows.number.data(), rows.column.data(),
                          rows.value.data());
  HYPRE_IJMatrixAssemble(matrix);
  return matrix;
}

template <class Object, class Handle, class Get>
Object object_of(Handle handle, Get get) {
  void* object = nullptr;
  get(handle, &object);
  return static_cast<Object>(object);
}

HYPRE_Solver make_multigrid() {
  HYPRE_Solver multigrid = nullptr;
  HYPRE_BoomerAMGCreate(&multigrid);
  HYPRE_BoomerAMGSetPrintLevel(multigrid, 0);
  HYPRE_BoomerAMGSetCoarsenType(multigrid, 10);
  HYPRE_BoomerAMGSetInterpType(multigrid, 17);
  HYPRE_BoomerAMGSetPMaxElmts(multigrid, 4);
  HYPRE_BoomerAMGSetStrongThreshold(multigrid, 0.25);
  HYPRE_BoomerAMGSetRelaxOrder(multigrid, 0);
  HYPRE_BoomerAMGSetCycleRelaxType(multigrid, 13, 1);
  HYPRE_BoomerAMGSetCycleRelaxType(multigrid, 14, 2);
  HYPRE_BoomerAMGSetCycleRelaxType(multigrid, 9, 3);
  HYPRE_BoomerAMGSetTol(multigrid, 0.0);
  HYPRE_BoomerAMGSetMaxIter(multigrid, 1);
  return multigrid;
}

double bare_multigrid(const seepage::SymmetricMatrix& lower, std::span<double> right_hand_side) {
  const Rows rows = rows_of(lower);
  const ProcessorClock clock;
  HYPRE_IJMatrix matrix = make_matrix(rows);
  const std::vector<double> given(right_hand_side.begin(), right_hand_side.end());
  HYPRE_IJVector right = make_vector(rows, given);
  HYPRE_IJVector left = make_vector(rows, std::vector<double>(given.size(), 0.0));
  const auto a = object_of<HYPRE_ParCSRMatrix>(matrix, HYPRE_IJMatrixGetObject);
  const auto b = object_of<HYPRE_ParVector>(right, HYPRE_IJVectorGetObject);
  const auto x = object_of<HYPRE_ParVector>(left, HYPRE_IJVectorGetObject);
  HYPRE_Solver multigrid = make_multigrid();
  HYPRE_Solver krylov = nullptr;
  HYPRE_ParCSRPCGCreate(MPI_COMM_SELF, &krylov);
  HYPRE_PCGSetTol(krylov, reduction);
  HYPRE_PCGSetMaxIter(krylov, 500);
  HYPRE_PCGSetTwoNorm(krylov, 1);
  HYPRE_ParCSRPCGSetPrecond(krylov, HYPRE_BoomerAMGSolve, HYPRE_BoomerAMGSetup, multigrid);
  HYPRE_ParCSRPCGSetup(krylov, a, b, x);
  HYPRE_ParCSRPCGSolve(krylov, a, b, x);
  const double seconds = clock.seconds();
  int iterations = 0;
  double residual = 1.0;
  HYPRE_PCGGetNumIterations(krylov, &iterations);
  HYPRE_PCGGetFinalRelativeResidualNorm(krylov, &residual);
  HYPRE_ClearAllErrors();
  HYPRE_ParCSRPCGDestroy(krylov);
  HYPRE_BoomerAMGDestroy(multigrid);
  HYPRE_IJVectorDestroy(left);
  HYPRE_IJVectorDestroy(right);
  HYPRE_IJMatrixDestroy(matrix);
  if (!(residual <= reduction)) {
    throw std::runtime_error("the bare solver found no solution");
  }
  return seconds;
}

void measure(Results& results) {
  constexpr int rounds = 4;
  // Starts MPI and hypre, which the times do not count.
  const auto started = seepage::make_multigrid_solver();
  const mesh::Mesh mesh = make_flow_mesh(1'000'000);
  FlowCase flow;
  compare_steady("steady.fractured.1e6", mesh, flow, bare_multigrid, rounds, results);
  flow.aperture = 1e-3;
  compare_steady("steady.wide_fractures.1e6", mesh, flow, bare_multigrid, rounds, results);
  flow.fractured = false;
  compare_steady("steady.tied.1e6", mesh, flow, bare_multigrid, rounds, results);
}

}  // namespace

int main(int argc, char** argv) {
  return run_benchmark(argc, argv, measure);
}

#else

int main(int argc, char** argv) {
  return percolith::bench::run_benchmark(argc, argv, [](percolith::bench::Results&) {
    fmt::print("\nsteady field on 1e6 triangles: built without hypre, nothing to compare\n");
  });
}

#endif
