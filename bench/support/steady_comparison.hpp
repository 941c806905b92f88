// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/seepage/linear_solver.hpp"

#include <span>
#include <string>

#include "bench/support/flow_case.hpp"
#include "bench/support/results.hpp"

namespace percolith::bench {

/// Solves a system from nothing and returns the processor time it took, s, without what it takes
/// to bring the matrix into the form the solver reads.
using BareSolver = double (*)(const seepage::SymmetricMatrix& matrix,
                              std::span<double> right_hand_side);

/// Compares `solve_steady` on a case - graph, assembly, solution, refinement, contents - with a
/// bare solver on the very same matrix and right-hand side: both in turn, `rounds` times, the best
/// processor time of each. Prints where the time goes and records the ratio as `name`, which must
/// not exceed 1.3.
void compare_steady(const std::string& name, const mesh::Mesh& mesh, const FlowCase& flow,
                    BareSolver bare, int rounds, Results& results);

}  // namespace percolith::bench
