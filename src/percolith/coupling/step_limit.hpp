// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/coupling/coupled_model.hpp"
#include "percolith/mechanics/step_limit.hpp"

#include <limits>
#include <vector>

namespace percolith::coupling {

/// Limits of the step in coupled motion: those of the wet rock, and the stiffness of the fluid in
/// each crack node, which grows as the crack closes.
class StepLimit {
public:
  explicit StepLimit(const CoupledModel& model);

  /// Longest stable step of the motion with the cracks as they stand, s.
  [[nodiscard]] double motion(const CoupledModel& model);
  /// The same where a crack runs along the edge of any triangle, s, with faces that have not moved:
  /// what `motion` comes down to where rock breaks, and falls below where cracks are pressed shut.
  /// Infinite without joints that may break.
  [[nodiscard]] double in_new_cracks(const CoupledModel& model) const;
  /// Longest stable explicit step of the pores, s, whatever joints may break: storage over the sum
  /// of conductances of each single corner, exchange with cracks at both its edges included.
  [[nodiscard]] double pores() const { return pores_; }
  [[nodiscard]] double rock() const { return rock_; }

private:
  std::vector<mechanics::Frequencies> triangle_;
  double rock_ = std::numeric_limits<double>::infinity();
  double pores_ = std::numeric_limits<double>::infinity();
  // Where cracks are: length of the joints at each vertex, m, and stiffness at each corner, N/m a
  // m.
  std::vector<double> pushed_, stiffness_;
};

}  // namespace percolith::coupling
