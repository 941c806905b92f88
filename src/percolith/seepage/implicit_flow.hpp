// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/archive.hpp"
#include "percolith/core/execution.hpp"
#include "percolith/seepage/account.hpp"
#include "percolith/seepage/active_set.hpp"
#include "percolith/seepage/flow_graph.hpp"
#include "percolith/seepage/graph_conditions.hpp"
#include "percolith/seepage/pressure_system.hpp"

#include <span>
#include <vector>

namespace percolith::seepage {

/// Which nodes an implicit step solves for.
enum class Network { all, cracks };

/// Backward Euler over pore and crack nodes together (theory.md section 6). Every step solves for
/// the pressures, then moves the contents by the flows those pressures drive, so that fluid is
/// conserved whatever the solution's accuracy.
class ImplicitFlow {
public:
  /// Over everything, or over the cracks alone, whose exchange with the pores starts from their
  /// present pressures then.
  explicit ImplicitFlow(const Model& model, Network network = Network::all);

  /// To be called when cracks have opened or pores have grown since the last step, but no joint has
  /// broken: that takes a new object.
  void refresh(const Model& model);

  /// Computes a step of `dt` seconds; false when the iteration over saturations and active set did
  /// not settle, and the step must be tried again with a smaller dt. The model stays as it was.
  [[nodiscard]] bool attempt(const Model& model, double dt, Execution& execution);
  /// The same for a step that starts at time `t`, s. Where `compliance` (m2/Pa, per node of the
  /// graph) is given, the room of each node grows besides with its pressure beyond the present one:
  /// an iteration towards a room that follows the pressure.
  [[nodiscard]] bool attempt(const Model& model, double t, double dt, Execution& execution,
                             std::span<const double> compliance = {});
  /// Shows the pressures and saturations of the attempted step in the model, whose contents stay.
  void show_pressures(Model& model) const;

  /// Local error of the attempted step: the change of content that the present and the previous
  /// rates disagree about, over the content that a change of pressure by its range in the model
  /// (full nodes) or by all of the void (partly empty nodes) would mean; root mean square over
  /// pores or cracks, whichever is larger.
  [[nodiscard]] double error() const { return error_; }

  /// Makes the attempted step the state of the model and books what the conditions let in.
  void accept(Model& model);
  /// The same, but for the accounts and the time of the model.
  void apply(Model& model);
  /// Fluid that left the cracks through their faces in the attempted step, m2; to be called before
  /// the step is made the state of the model. Where crack and faces share one pressure it is what
  /// the crack neither keeps nor passes on; at a pressure that a condition holds there, nothing.
  [[nodiscard]] double leaked_from_cracks(const Model& model) const;
  /// What the conditions let in in the attempted step.
  [[nodiscard]] std::span<const Booking> bookings() const { return booked_; }

  [[nodiscard]] int iterations() const { return iterations_; }
  [[nodiscard]] const FlowGraph& graph() const { return graph_; }
  [[nodiscard]] Index unknowns() const { return system_.unknowns(); }
  /// What the next step takes over from those before, beside the model.
  void describe_state(StateArchive& archive);

private:
  void prepare(const Model& model, double t, double dt);
  [[nodiscard]] bool iterate(const Model& model, double dt, Execution& execution);
  void finish(const Model& model, double dt);
  void estimate_error(const Model& model, double dt);
  [[nodiscard]] double leaked_at_shared_pressure(const Model& model) const;

  FlowGraph graph_;
  GraphConditions conditions_;
  PressureSystem system_;
  ActiveSet active_;
  double time_ = 0.0;  // at which the attempted step starts
  double dt_ = 0.0;
  double factorised_dt_ = 0.0;  // of a matrix without partly empty nodes; 0: none
  int iterations_ = 0;
  double error_ = 0.0;
  GraphState start_, state_;
  std::vector<double> conductance_, storage_rate_, source_, rate_;
  std::vector<double> flow_, inflow_;
  std::vector<CompensatedSum> content_;  // at the end of the attempted step
  std::vector<double> previous_rate_;    // of content, m2/s, in the last accepted step
  double previous_dt_ = 0.0;
  std::vector<Booking> booked_;  // of the attempted step
};

}  // namespace percolith::seepage
