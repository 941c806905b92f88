// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/coupling/scheme.hpp"
#include "percolith/seepage/explicit_step.hpp"
#include "percolith/seepage/implicit_flow.hpp"

#include <memory>
#include <vector>

namespace percolith::coupling {

/// Advances rock and fluid together (Fig. 11): the pressures act on the rock, the rock moves, what
/// has failed breaks and lets fluid in, the new room changes the pressures, and the fluid flows.
/// Motion is explicit, the cracks are implicit, the pores explicit in as many steps as they need.
class CoupledStep : public Scheme {
public:
  /// `pore_limit`: longest stable explicit step of the pores, s.
  CoupledStep(CoupledModel& model, double pore_limit);

  /// The caller keeps dt below the limit of the motion.
  mechanics::Changes advance(double dt, Execution& execution) override;
  void network_changed() override;
  void describe_state(StateArchive& archive) override;
  [[nodiscard]] double leaked() const override { return leaked_.total(); }
  /// Those of the cracks.
  [[nodiscard]] int iterations() const override { return iterations_; }

private:
  void flow(double dt, Execution& execution);
  void flow_in_cracks(double t, double dt, int halvings, Execution& execution);
  void flow_in_pores(double t, double dt, Execution& execution);

  CoupledModel* model_;
  double pore_limit_;
  seepage::ExplicitStep pores_;
  std::unique_ptr<seepage::ImplicitFlow> cracks_;
  std::vector<seepage::Booking> bookings_;
  CompensatedSum leaked_;
  int iterations_ = 0;
};

}  // namespace percolith::coupling
