// SPDX-License-Identifier: BSD-3-Clause
// A steady field on 1e5 triangles against the bare factorisation and solution of its equations.
#include <Eigen/SparseCholesky>

#include <stdexcept>

#include "bench/support/measure.hpp"
#include "bench/support/steady_comparison.hpp"

namespace {

using namespace percolith;
using namespace percolith::bench;

double bare_factorisation(const seepage::SymmetricMatrix& matrix,
                          std::span<double> right_hand_side) {
  const ProcessorClock clock;
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, mesh::Index>;
  const Eigen::Map<const Matrix> view(
      matrix.unknowns(), matrix.unknowns(), static_cast<Eigen::Index>(matrix.row.size()),
      matrix.column_start.data(), matrix.row.data(), matrix.value.data());
  const Eigen::SimplicialLDLT<Matrix, Eigen::Lower> factor(view);
  Eigen::Map<Eigen::VectorXd> b(right_hand_side.data(),
                                static_cast<Eigen::Index>(right_hand_side.size()));
  b = factor.solve(b).eval();
  if (factor.info() != Eigen::Success) {
    throw std::runtime_error("the bare factorisation failed");
  }
  return clock.seconds();
}

void measure(Results& results) {
  constexpr int rounds = 15;
  const mesh::Mesh mesh = make_flow_mesh(100'000);
  FlowCase flow;
  compare_steady("steady.fractured.1e5", mesh, flow, bare_factorisation, rounds, results);
  flow.fractured = false;
  compare_steady("steady.tied.1e5", mesh, flow, bare_factorisation, rounds, results);
}

}  // namespace

int main(int argc, char** argv) {
  return run_benchmark(argc, argv, measure);
}
