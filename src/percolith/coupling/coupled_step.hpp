// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/archive.hpp"
#include "percolith/coupling/coupled_model.hpp"
#include "percolith/seepage/explicit_step.hpp"
#include "percolith/seepage/implicit_flow.hpp"

#include <memory>
#include <vector>

namespace percolith::coupling {

/// Advances rock and fluid together (Fig. 11): the pressures act on the rock, the rock moves, what
/// has failed breaks and lets fluid in, the new room changes the pressures, and the fluid flows.
/// Motion is explicit, the cracks are implicit, the pores explicit in as many steps as they need.
class CoupledStep {
public:
  /// `pore_limit`: longest stable explicit step of the pores, s.
  CoupledStep(CoupledModel& model, double pore_limit);

  /// One step of `dt` seconds; the caller keeps dt below the limit of the motion. Throws
  /// SolverError when the flow in the cracks has no solution.
  mechanics::Changes advance(double dt, Execution& execution);

  /// To be called when conditions have been added since the last step.
  void network_changed();

  /// What the next step takes over from those before, beside the model; to be read once the model
  /// is.
  void describe_state(StateArchive& archive);

  /// Fluid that has leaked out of the cracks into the rock since time zero, m2.
  [[nodiscard]] double leaked() const { return leaked_.total(); }
  /// Iterations of the cracks in the last step.
  [[nodiscard]] int iterations() const { return iterations_; }

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
