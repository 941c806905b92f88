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
  StepLimit() = default;
  explicit StepLimit(const CoupledModel& model);

  /// Longest stable step of the motion with the cracks as they stand, s.
  [[nodiscard]] double motion(const CoupledModel& model) const;
  /// Whether the fluid in a crack rules that step.
  [[nodiscard]] bool ruled_by_crack(const CoupledModel& model) const {
    return motion(model) < rock_;
  }
  /// Longest stable explicit step of the pores, s, whatever joints may break: storage over the sum
  /// of conductances of each single corner, exchange with cracks at both its edges included.
  [[nodiscard]] double pores() const { return pores_; }
  [[nodiscard]] double rock() const { return rock_; }

private:
  std::vector<mechanics::Frequencies> triangle_;
  double rock_ = std::numeric_limits<double>::infinity();
  double pores_ = std::numeric_limits<double>::infinity();
};

}  // namespace percolith::coupling
