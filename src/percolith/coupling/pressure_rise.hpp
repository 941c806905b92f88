// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/coupling/coupled_model.hpp"

#include <vector>

namespace percolith::coupling {

/// How far the pressures of a step have gone away from those at its start.
class PressureRise {
public:
  explicit PressureRise(const seepage::Model& water);

  /// Takes the present pressures into account: those of pores, and of cracks that were open at the
  /// start. Where a crack was only filling, water brings the pressure it had elsewhere: what counts
  /// is by how much that is above the highest at the start.
  void see(const seepage::Model& water);
  /// The largest difference so far over the largest pressure it was seen with, 1.
  [[nodiscard]] double largest() const { return largest_; }

private:
  std::vector<double> pores_, cracks_;  // Pa, at the start
  std::vector<Index> full_, filling_;   // nodes of cracks, at the start
  double highest_ = 0.0;                // Pa, at the start
  double largest_ = 0.0;
};

}  // namespace percolith::coupling
