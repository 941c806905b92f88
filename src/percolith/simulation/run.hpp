// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/execution.hpp"
#include "percolith/seepage/model.hpp"
#include "percolith/simulation/checkpoints.hpp"
#include "percolith/simulation/event_clock.hpp"
#include "percolith/simulation/frames.hpp"
#include "percolith/simulation/pause.hpp"
#include "percolith/simulation/report.hpp"
#include "percolith/simulation/settling.hpp"
#include "percolith/simulation/setup.hpp"

#include <functional>
#include <optional>
#include <string_view>

namespace percolith::simulation {

/// A model while it runs.
struct RunState {
  seepage::Model model;
  Execution execution;
  ProbeReader probes;
  double in_place_at_start = 0.0;  ///< fluid, m2
  Summary summary;
};

/// Throws InputError when a steady run, or one that starts from a steady state, has no pressure
/// datum somewhere.
void require_datum(const Setup& setup, const seepage::Model& model);

/// A step as a scheme made it.
struct StepMade {
  double size = 0.0;   ///< s
  double asked = 0.0;  ///< s: what the scheme would have taken had no event been in the way
  std::int64_t iterations = 0;
  const char* limited_by = "";
};

/// What differs between the schemes that advance in time.
struct TransientScheme {
  /// Advances the model by one step that does not pass `event` (s) and returns it.
  std::function<StepMade(double event)> make_step;
  double history_interval = 0.0;          ///< s; 0: a row a step
  std::int64_t steps_between_checks = 1;  ///< for values that are not numbers, and for rest
  /// Walks through what the next step takes over from those before, beside the model; may be empty.
  std::function<void(StateArchive&)> state{};
};

/// The loop over steps, outputs and history that all transient runs share.
class TransientRun {
public:
  /// `setup` and `run` must outlive it.
  TransientRun(const Setup& setup, RunState& run, TransientScheme scheme);
  /// As the members of `Simulation` of these names.
  void begin(Observer& observer);
  void begin_from(StateArchive& state, Observer& observer);
  Reached advance(Observer& observer, const std::function<bool()>& stop, const Pause& pause);
  void leave(Observer& observer);

private:
  void describe_state(StateArchive& archive);
  [[nodiscard]] StepMade make_step(double event);
  /// Looks whether the flow has settled, where that is wanted and it is time to.
  void look_for_rest();
  [[nodiscard]] bool is_over() const;
  void report_step(Observer& observer);

  const Setup& setup_;
  RunState& run_;
  TransientScheme scheme_;
  EventClock clock_;
  HistoryClock history_;
  Settling settling_;
  std::optional<Checkpoints> checkpoints_;
  StepEnd last_;
  double size_ = 0.0;  // s, of the last step
};

/// One steady solution, reported as one frame.
void run_steady(const Setup& setup, RunState& run, Observer& observer);
/// Backward Euler with fixed or error-controlled steps. `setup` and `run` must outlive the scheme.
[[nodiscard]] TransientScheme implicit_scheme(const Setup& setup, RunState& run);
/// Explicit steps below the stability limit; likewise.
[[nodiscard]] TransientScheme explicit_scheme(const Setup& setup, RunState& run);

/// The summary with the totals of the present state.
[[nodiscard]] Summary finished_summary(const RunState& run);

/// Sends fields and probes.
void report_frame(const Setup& setup, RunState& run, Observer& observer);
/// Sends a row of history for the step that ended now.
void report_history(RunState& run, double step_size, Observer& observer);
/// Throws SolverError when the state holds a value that is not a number, or a node from which more
/// fluid was taken than it held.
void require_valid(const RunState& run);
/// The same for a model in step `step`; `more` is added to what helps where a value is no number.
void require_valid(const seepage::Model& model, std::int64_t step, std::string_view more = "");

}  // namespace percolith::simulation
