// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/execution.hpp"
#include "percolith/seepage/model.hpp"
#include "percolith/simulation/frames.hpp"
#include "percolith/simulation/report.hpp"
#include "percolith/simulation/setup.hpp"

#include <functional>
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
  std::int64_t steps_between_checks = 1;  ///< for values that are not numbers
  /// Walks through what the next step takes over from those before, beside the model; may be empty.
  std::function<void(StateArchive&)> state{};
};

/// The loop over steps, outputs and history that all transient runs share. `from`: the state to go
/// on from; null: that of time zero.
void run_transient(const Setup& setup, RunState& run, Observer& observer,
                   const std::function<bool()>& stop, const TransientScheme& scheme,
                   StateArchive* from);

/// One steady solution, reported as one frame.
void run_steady(const Setup& setup, RunState& run, Observer& observer);
/// Backward Euler with fixed or error-controlled steps; `from` as for `run_transient`.
void run_implicit(const Setup& setup, RunState& run, Observer& observer,
                  const std::function<bool()>& stop, StateArchive* from);
/// Explicit steps below the stability limit; `from` as for `run_transient`.
void run_explicit(const Setup& setup, RunState& run, Observer& observer,
                  const std::function<bool()>& stop, StateArchive* from);

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
