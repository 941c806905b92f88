// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/execution.hpp"
#include "percolith/seepage/account.hpp"
#include "percolith/seepage/joint_flow.hpp"
#include "percolith/seepage/model.hpp"

#include <array>
#include <vector>

namespace percolith::seepage {

/// A corner at the face of one or two cracks, and where the flows into it stand.
struct CrackFace {
  Index corner;
  std::array<Index, 2> flow;  ///< of the lower joint first; the second may be `none`
};

/// Advances a model by explicit steps (theory.md section 6): flows from the present pressures,
/// contents from the flows, pressures from the contents. Holds the buffers the flows are gathered
/// from.
class ExplicitStep {
public:
  explicit ExplicitStep(const Model& model);

  /// One step of `dt` seconds. The caller keeps dt below the stability limit. Adds what passes the
  /// conditions to the accounts of the model.
  void advance(Model& model, double dt, Execution& execution);

  /// To be called when joints have broken since the last step.
  void network_changed(const Model& model);

private:
  void advance_pores(Model& model, double dt, Execution& execution);
  void apply_rates(Model& model, double dt);
  void apply_pressures(Model& model, double t);

  std::vector<double> inflow_;         // per corner, m2/s
  JointsAcross across_;                // of finite joints; empty when all are tied
  std::vector<double> exchange_flow_;  // per broken joint: into each of its four corners, m2/s
  std::vector<double> crack_flow_;     // per broken joint: from end 0 to end 1, m2/s
  std::vector<CrackFace> faces_;
  mesh::IndexTable crack_ends_;    // per open crack node: broken joint k, end e as 2 k + e
  std::vector<Booking> bookings_;  // of the present step
};

}  // namespace percolith::seepage
