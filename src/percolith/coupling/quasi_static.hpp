// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/coupling/approach.hpp"
#include "percolith/coupling/scheme.hpp"
#include "percolith/mechanics/relaxation.hpp"
#include "percolith/seepage/implicit_flow.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace percolith::coupling {

/// How exactly a quasi-static step is solved.
struct QuasiStaticOptions {
  double pressure_tolerance;  ///< change between iterations over the largest pressure
  double balance_tolerance;   ///< unbalanced force over that to be balanced
};

/// Advances slow flow and a rock always in balance by a fixed-stress split (theory.md section 25):
/// implicit flow in which each node has, besides its storage, an estimate of how the rock gives way
/// under its pressure; then the balance of forces at these pressures; and so on until neither
/// changes any more. What breaks on the way lets fluid in at once; it breaks only in
/// steps so short that the pressures hardly rise in them, and a step without a solution leaves no
/// trace.
class QuasiStatic : public Scheme {
public:
  QuasiStatic(CoupledModel& model, const QuasiStaticOptions& options);

  /// One step, or as many shorter ones as it takes.
  mechanics::Changes advance(double dt, Execution& execution) override;
  void listen(const std::function<bool()>& stop) override { stop_ = stop; }
  [[nodiscard]] Doing doing() const override;
  [[nodiscard]] bool gave_up() const override { return gave_up_; }
  void network_changed() override;
  void describe_state(StateArchive& archive) override;
  [[nodiscard]] double leaked() const override { return leaked_.total(); }
  /// Those of the split, of all parts of the step together.
  [[nodiscard]] int iterations() const override { return iterations_; }
  [[nodiscard]] int parts() const override { return parts_; }

private:
  /// How the rock goes to rest: as a whole; in damped motion; in a few steps of it at a time, while
  /// cracks run; as a whole once more where motion did not come to its end.
  enum class Pace { pulling, swinging, following, settling };
  /// What a step that is given up or tried again goes back to.
  struct Moment {
    std::string state;  // of rock, water and scheme
    std::size_t broke = 0, parted = 0;
  };
  /// How the iteration of a part of a step has ended.
  struct Ending {
    bool is_solved = false;
    bool is_too_long = false;   // rock broke, at pressures that had risen too far
    bool wants_motion = false;  // the whole rock does not go on steadily
    bool broke = false;         // joints broke, or let fluid in
    double distance = 0.0;      // of the pressures from those looked for, over the largest
  };

  void advance_part(double dt, int halvings, const Moment& start, Execution& execution);
  [[nodiscard]] Ending solve_as_whole(double dt, bool may_be_too_long, Execution& execution);
  void accept(double dt);
  [[nodiscard]] Ending solve(double dt, bool may_be_too_long, Execution& execution);
  [[nodiscard]] bool solve_flow(double dt, Execution& execution);
  void relax(Execution& execution);
  void pull_to_rest(Execution& execution);
  void follow_cracks(Execution& execution);
  void swing_to_rest(Execution& execution);
  void settle(Execution& execution);
  /// Follows cracks where some have run, otherwise goes on at the pace `other`.
  void follow_or(Pace other);
  void take(mechanics::Changes changes, Execution& execution);
  [[nodiscard]] double force_to_balance() const;
  [[nodiscard]] double unbalanced_ratio() const;
  [[nodiscard]] bool is_balanced() const { return unbalanced_ratio() < options_.balance_tolerance; }
  bool note(mechanics::Changes changes);
  void measure(Execution& execution);
  void set_compliance();
  [[nodiscard]] bool is_settled(const Approach& approach) const;
  void soften(const Approach& approach);
  [[nodiscard]] Moment present_moment();
  void go_back(const Moment& moment);
  void try_again_from(const Moment& moment);
  [[nodiscard]] bool is_asked_to_stop();
  [[noreturn]] void refuse(double dt, const Ending& ending) const;

  CoupledModel* model_;
  QuasiStaticOptions options_;
  mechanics::Relaxation relaxation_;
  std::unique_ptr<seepage::ImplicitFlow> flow_;
  std::vector<double> compliance_;  // per node of the graph, m2/Pa
  std::vector<double> soft_pores_;  // per corner: alpha^2 V/(lambda + G), m2/Pa
  mechanics::Changes changes_;      // of the present step
  std::vector<seepage::Booking> bookings_;
  CompensatedSum leaked_;
  double time_ = 0.0;  // s, at the start of the present part
  int iterations_ = 0;
  int parts_ = 0;
  double softness_ = 1.0;  // factor on the compliance of cracks
  Pace pace_ = Pace::pulling;
  int calm_ = 0;  // iterations since something broke
  // Of the last relaxation: whether rock broke in it, and whether it came to its end.
  bool broke_ = false;
  bool is_at_rest_ = false;
  std::function<bool()> stop_;
  bool gave_up_ = false;
};

}  // namespace percolith::coupling
