// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/linear_solver.hpp"
#include "percolith/seepage/pressure_system.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <random>

#include "unit/support/flow_model.hpp"

namespace percolith::seepage {
namespace {

using test::at;

/// The lower triangle of a dense matrix, all entries kept.
SymmetricMatrix lower_of(const Eigen::MatrixXd& dense) {
  SymmetricMatrix matrix;
  matrix.column_start.push_back(0);
  for (Eigen::Index c = 0; c < dense.cols(); ++c) {
    for (Eigen::Index r = c; r < dense.rows(); ++r) {
      matrix.row.push_back(static_cast<Index>(r));
      matrix.value.push_back(dense(r, c));
    }
    matrix.column_start.push_back(static_cast<Index>(matrix.row.size()));
  }
  return matrix;
}

Eigen::MatrixXd positive_definite(int n, unsigned seed) {
  std::srand(seed);
  const Eigen::MatrixXd a = Eigen::MatrixXd::Random(n, n);
  return a * a.transpose() + Eigen::MatrixXd::Identity(n, n);
}

TEST(DirectSolver, SolvesAndSolvesAgainWithOtherValues) {
  const auto solver = make_direct_solver();
  for (const unsigned seed : {1u, 2u}) {
    const Eigen::MatrixXd dense = positive_definite(30, seed);
    const SymmetricMatrix matrix = lower_of(dense);
    ASSERT_TRUE(solver->factorize(matrix));
    const Eigen::VectorXd expected = Eigen::VectorXd::Random(30);
    Eigen::VectorXd b = dense * expected;
    ASSERT_TRUE(solver->solve(std::span<double>(b.data(), 30), 1e-12));
    EXPECT_LT((b - expected).norm(), 1e-9);
  }
  // Another pattern needs a reset.
  solver->reset();
  const SymmetricMatrix small = lower_of(positive_definite(5, 3));
  EXPECT_TRUE(solver->factorize(small));
}

TEST(DirectSolver, RefusesWhatIsNotPositiveDefinite) {
  Eigen::MatrixXd indefinite = positive_definite(6, 1);
  indefinite(3, 3) = -1.0;
  EXPECT_FALSE(make_direct_solver()->factorize(lower_of(indefinite)));
  EXPECT_FALSE(make_direct_solver()->factorize(lower_of(Eigen::MatrixXd::Zero(4, 4))));
}

TEST(DirectSolver, ReportsASolutionThatIsNoNumber) {
  const SymmetricMatrix matrix = lower_of(positive_definite(4, 1));
  const auto solver = make_direct_solver();
  ASSERT_TRUE(solver->factorize(matrix));
  std::vector<double> b{1.0, test::infinity, 0.0, 0.0};
  EXPECT_FALSE(solver->solve(b, 1e-12));
}

TEST(PressureSystem, IsTheGraphLaplacianWithStorageWithoutPrescribedNodes) {
  const test::Grid grid{.columns = 3, .rows = 3, .jitter = 0.2, .mixed_diagonals = true};
  auto file = test::make_grid(grid);
  test::add_column_curve(grid, file, "crack", 1, 0, 3);
  test::FlowOptions options;
  options.rock.permeability = {3e-13, 1e-13, -1.2e-13};
  Model model = test::make_flow(file, options);
  test::break_curve(model, "crack");
  const FlowGraph graph = make_flow_graph(model);
  std::vector<std::uint8_t> prescribed(at(graph.nodes()), 0);
  prescribed[2] = prescribed[5] = 1;
  std::vector<std::uint8_t> held(prescribed.size(), 0);
  held[7] = 1;
  std::vector<double> storage_rate(graph.storage);
  std::vector<double> source(prescribed.size(), 0.0);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  GraphState state = gather_state(model, graph);
  for (std::size_t n = 0; n < source.size(); ++n) {
    storage_rate[n] *= 10.0;
    source[n] = 1e-9 * unit(random);
    state.pressure[n] = 1e5 * unit(random);
  }
  // The same equations, dense and in full.
  const auto nodes = static_cast<Eigen::Index>(graph.nodes());
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(nodes, nodes);
  Eigen::VectorXd right(nodes);
  for (Index e = 0; e < graph.edges(); ++e) {
    const Index a = graph.from[at(e)];
    const Index b = graph.to[at(e)];
    const double c = graph.conductance[at(e)];
    dense(a, a) += c;
    dense(b, b) += c;
    dense(a, b) -= c;
    dense(b, a) -= c;
  }
  const double reference = 100.0;
  for (Index n = 0; n < graph.nodes(); ++n) {
    const bool fixed = prescribed[at(n)] != 0 || held[at(n)] != 0;
    if (fixed) {
      dense.row(n).setZero();
      dense(n, n) = 1.0;
      right[n] = state.pressure[at(n)];
    } else {
      dense(n, n) += storage_rate[at(n)];
      right[n] = source[at(n)] + storage_rate[at(n)] * reference;
    }
  }
  const Eigen::VectorXd expected = dense.fullPivLu().solve(right);
  PressureSystem system(graph, prescribed);
  EXPECT_EQ(system.unknowns(), graph.nodes() - 2);
  EXPECT_FALSE(system.is_unknown(2));
  ASSERT_TRUE(system.assemble(graph, graph.conductance, storage_rate, held));
  ASSERT_TRUE(system.solve(graph, graph.conductance, storage_rate, source, reference, state));
  for (Index n = 0; n < graph.nodes(); ++n) {
    EXPECT_NEAR(state.pressure[at(n)] + state.change[at(n)], expected[n], 1e-9 * 1e5);
  }
}

}  // namespace
}  // namespace percolith::seepage
