// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/coupling/scheme.hpp"
#include "percolith/seepage/implicit_flow.hpp"

#include <memory>
#include <vector>

namespace percolith::coupling {

/// How exactly a quasi-static step is solved, and by which steps of the motion.
struct QuasiStaticOptions {
  double pressure_tolerance = 1e-3;  ///< change between iterations over the largest pressure
  double balance_tolerance = 1e-4;   ///< unbalanced force over internal force
  double motion_step = 0.0;          ///< s: of the motion that finds the balance of forces
};

/// Advances slow flow and a rock always in balance by a fixed-stress split (theory.md section 25):
/// implicit flow in which each node has, besides its storage, an estimate of how the rock gives way
/// under its pressure; then damped motion at these pressures to the balance of forces; and so on
/// until neither changes any more. Rock that breaks on the way lets fluid in at once.
class QuasiStatic : public Scheme {
public:
  QuasiStatic(CoupledModel& model, const QuasiStaticOptions& options);

  /// One step, or as many shorter ones as it takes.
  mechanics::Changes advance(double dt, Execution& execution) override;
  void network_changed() override;
  void describe_state(StateArchive& archive) override;
  [[nodiscard]] double leaked() const override { return leaked_.total(); }
  /// Those of the split, of all parts of the step together.
  [[nodiscard]] int iterations() const override { return iterations_; }
  [[nodiscard]] int parts() const override { return parts_; }

private:
  void advance_part(double dt, int halvings, Execution& execution);
  [[nodiscard]] bool solve(double dt, Execution& execution);
  [[nodiscard]] bool solve_flow(double dt, Execution& execution);
  void relax(Execution& execution);
  bool note(mechanics::Changes changes);
  void measure(Execution& execution);
  void set_compliance();
  [[nodiscard]] double largest_change() const;

  CoupledModel* model_;
  QuasiStaticOptions options_;
  std::unique_ptr<seepage::ImplicitFlow> flow_;
  std::vector<double> compliance_;  // per node of the graph, m2/Pa
  std::vector<double> soft_pores_;  // per corner: alpha^2 V/(lambda + G), m2/Pa
  std::vector<double> before_;      // pressures of the last iteration, Pa
  mechanics::Changes changes_;      // of the present step
  std::vector<seepage::Booking> bookings_;
  CompensatedSum leaked_;
  double time_ = 0.0;  // s, at the start of the present part
  int iterations_ = 0;
  int parts_ = 0;
  double softness_ = 1.0;  // factor on the compliance of cracks
  // Of the last relaxation: whether rock broke in it, and whether it came to its end.
  bool broke_ = false;
  bool is_at_rest_ = false;
};

}  // namespace percolith::coupling
