// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/linear_solver.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace percolith::seepage {
namespace {

/// Conductances on an n x n grid, a thousand times larger along every tenth row; the left side is
/// tied to a given pressure.
SymmetricMatrix grid_matrix(Index n) {
  const auto conductance = [](Index row) { return row % 10 == 5 ? 1000.0 : 1.0; };
  SymmetricMatrix matrix;
  matrix.column_start.push_back(0);
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i) {
      const double along = conductance(j);
      const double diagonal = (i == 0      ? 2.0
                               : i + 1 < n ? 2.0
                                           : 1.0) *
                                  along +
                              (j > 0 ? 1.0 : 0.0) + (j + 1 < n ? 1.0 : 0.0);
      const Index unknown = j * n + i;
      const auto add = [&](Index row, double value) {
        matrix.row.push_back(row);
        matrix.value.push_back(value);
      };
      add(unknown, diagonal);
      if (i + 1 < n) {
        add(unknown + 1, -along);
      }
      if (j + 1 < n) {
        add(unknown + n, -1.0);
      }
      matrix.column_start.push_back(static_cast<Index>(matrix.row.size()));
    }
  }
  return matrix;
}

std::vector<double> some_inflows(Index unknowns) {
  std::vector<double> inflow(static_cast<std::size_t>(unknowns));
  for (std::size_t i = 0; i < inflow.size(); ++i) {
    inflow[i] = std::sin(static_cast<double>(i * i));
  }
  return inflow;
}

TEST(MultigridSolver, AgreesWithTheFactorisationAndTakesNewValues) {
  const auto multigrid = make_multigrid_solver();
  if (multigrid == nullptr) {
    GTEST_SKIP() << "built without hypre";
  }
  SymmetricMatrix matrix = grid_matrix(60);
  for (const double factor : {1.0, 7.0}) {
    for (double& value : matrix.value) {
      value *= factor;
    }
    const auto direct = make_direct_solver();
    std::vector<double> expected = some_inflows(matrix.unknowns());
    std::vector<double> found = expected;
    ASSERT_TRUE(direct->factorize(matrix));
    ASSERT_TRUE(direct->solve(expected, 0.0));
    ASSERT_TRUE(multigrid->factorize(matrix));
    ASSERT_TRUE(multigrid->solve(found, 1e-12 * norm(found)));
    for (std::size_t i = 0; i < found.size(); ++i) {
      ASSERT_NEAR(found[i], expected[i], 1e-9 * norm(expected));
    }
  }
}

TEST(MultigridSolver, StopsWhereItIsToldTo) {
  const auto multigrid = make_multigrid_solver();
  if (multigrid == nullptr) {
    GTEST_SKIP() << "built without hypre";
  }
  const SymmetricMatrix matrix = grid_matrix(40);
  ASSERT_TRUE(multigrid->factorize(matrix));
  const std::vector<double> inflow = some_inflows(matrix.unknowns());
  std::vector<double> rough = inflow;
  std::vector<double> fine = inflow;
  std::vector<double> none = inflow;
  ASSERT_TRUE(multigrid->solve(rough, 1e-2 * norm(inflow)));
  ASSERT_TRUE(multigrid->solve(fine, 1e-12 * norm(inflow)));
  ASSERT_TRUE(multigrid->solve(none, norm(inflow)));
  EXPECT_NE(rough, fine);
  EXPECT_EQ(none, std::vector<double>(none.size(), 0.0));
}

}  // namespace
}  // namespace percolith::seepage
