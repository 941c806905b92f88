// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/execution.hpp"
#include "percolith/seepage/model.hpp"

#include <vector>

namespace percolith::seepage {

/// Advances a model by explicit steps (theory 3.5): flows from the present pressures, contents
/// from the flows, pressures from the contents. Holds the buffers the flows are gathered from.
class ExplicitStep {
public:
  explicit ExplicitStep(const Model& model);

  /// One step of `dt` seconds. The caller keeps dt below the stability limit. Adds what passes the
  /// conditions to `model.let_in` and sets `model.rate`.
  void advance(Model& model, double dt, Execution& execution);

  /// To be called when joints have broken since the last step.
  void network_changed(const Model& model);

private:
  void apply_rates(Model& model, double dt);
  void apply_pressures(Model& model, double dt, double t);
  void book(Model& model, Index condition, double volume, double dt);

  std::vector<double> inflow_;        // per corner, from its triangle, m2/s
  std::vector<double> joint_flow_;    // per joint: into each of its four corners
  std::vector<double> crack_flow_;    // per joint: along the crack from end 0 to end 1
  std::vector<Index> active_joints_;  // finite or broken
  std::vector<std::uint8_t> active_;  // per vertex: an active joint ends here
  bool saturated_ = false;            // no node was partly empty at the start of the step
};

}  // namespace percolith::seepage
