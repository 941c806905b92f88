// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/coupling/scheme.hpp"
#include "percolith/seepage/explicit_step.hpp"
#include "percolith/seepage/implicit_flow.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace percolith::coupling {

/// Advances rock and fluid together (Fig. 11): the pressures act on the rock, the rock moves, what
/// has failed breaks and lets fluid in, the new room changes the pressures, and the fluid flows.
/// Motion is explicit and the cracks are implicit; the pores are explicit, in as many steps as they
/// need, or implicit together with the cracks.
class CoupledStep : public Scheme {
public:
  /// `pore_limit`: longest stable explicit step of the pores, s; implicit ones have none.
  CoupledStep(CoupledModel& model, PoreFlow pore_flow, double pore_limit);

  /// The caller keeps dt below the limit of the motion.
  mechanics::Changes advance(double dt, Execution& execution) override;
  void network_changed() override;
  void describe_state(StateArchive& archive) override;
  [[nodiscard]] double leaked() const override { return leaked_.total(); }
  /// Those of the implicit flow.
  [[nodiscard]] int iterations() const override { return iterations_; }

private:
  void flow(double dt, Execution& execution);
  [[nodiscard]] std::unique_ptr<seepage::ImplicitFlow> make_implicit() const;
  void flow_implicitly(double t, double dt, int halvings, Execution& execution);
  void flow_in_pores(double t, double dt, Execution& execution);

  CoupledModel* model_;
  double pore_limit_;
  std::optional<seepage::ExplicitStep> pores_;       // none where pores are implicit
  std::unique_ptr<seepage::ImplicitFlow> implicit_;  // of the cracks, or of all
  std::vector<seepage::Booking> bookings_;
  CompensatedSum leaked_;
  int iterations_ = 0;
};

}  // namespace percolith::coupling
