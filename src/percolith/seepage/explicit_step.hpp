// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/execution.hpp"
#include "percolith/seepage/account.hpp"
#include "percolith/seepage/joint_flow.hpp"
#include "percolith/seepage/model.hpp"
#include "percolith/seepage/node_blocks.hpp"

#include <array>
#include <vector>

namespace percolith::seepage {

/// A corner at the face of one or two cracks, and where the flows into it stand.
struct CrackFace {
  Index corner;
  std::array<Index, 2> flow;  ///< of the lower joint first; the second may be `none`
};

/// Which part of the fluid an explicit step advances.
enum class Fields { pores_and_cracks, pores };

/// Advances a model by explicit steps (theory.md section 6): flows from the present pressures,
/// contents from the flows, pressures from the contents. Holds the buffers the flows are gathered
/// from. Where cracks are advanced in another way, their exchange with the pores is too.
class ExplicitStep {
public:
  explicit ExplicitStep(const Model& model, Fields fields = Fields::pores_and_cracks);

  /// One step of `dt` seconds. The caller keeps dt below the stability limit. Adds what passes the
  /// conditions to the accounts of the model.
  void advance(Model& model, double dt, Execution& execution);

  /// The same from time `t` (s) on, but for the accounts and the time of the model: what passes the
  /// conditions is added to `bookings`.
  void step(Model& model, double t, double dt, Execution& execution,
            std::vector<Booking>& bookings);

  /// To be called when joints have broken since the last step.
  void network_changed(const Model& model);

private:
  void advance_pores(Model& model, double dt, Execution& execution);
  void apply_rates(Model& model, double t, double dt, std::vector<Booking>& bookings) const;
  void apply_pressures(Model& model, double t, std::vector<Booking>& bookings) const;
  void apply_crack_pressures(Model& model, double t, std::vector<Booking>& bookings) const;

  Fields fields_;

  std::vector<double> inflow_;         // per corner, m2/s
  JointsAcross across_;                // of finite joints; empty when all are tied
  NodeBlocks blocks_;                  // of tied ones; empty where joints are finite
  std::vector<double> exchange_flow_;  // per broken joint: into each of its four corners, m2/s
  std::vector<double> crack_flow_;     // per broken joint: from end 0 to end 1, m2/s
  std::vector<CrackFace> faces_;
  mesh::IndexTable crack_ends_;    // per open crack node: broken joint k, end e as 2 k + e
  std::vector<Booking> bookings_;  // of the last `advance`
};

}  // namespace percolith::seepage
