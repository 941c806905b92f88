// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/checkpoints.hpp"
#include "percolith/simulation/event_clock.hpp"
#include "percolith/simulation/run.hpp"
#include "percolith/simulation/state.hpp"

#include <algorithm>

namespace percolith::simulation {
namespace {

/// What to show as the reason for the size of a step.
const char* reason(const StepMade& step, double event, double output) {
  if (step.size >= step.asked * (1.0 - 1e-9)) {
    return step.limited_by;
  }
  return event < output ? "change of a schedule" : "output time";
}

}  // namespace

void run_transient(const Setup& setup, RunState& run, Observer& observer,
                   const std::function<bool()>& stop, const TransientScheme& scheme,
                   StateArchive* from) {
  const double end = setup.time.end;
  const EventClock clock(setup.output, end);
  HistoryClock history(setup.output.history_interval.value_or(scheme.history_interval));
  const auto state = [&](StateArchive& archive) {
    archive("run", run);
    archive("history", history);
    if (scheme.state) {
      scheme.state(archive);
    }
  };
  if (from != nullptr) {
    state(*from);
    observer.on_resume(run.model.state.time, run.summary.steps);
  } else {
    report_frame(setup, run, observer);
    if (history.due(0.0)) {
      report_history(run, 0.0, observer);
    }
  }
  Checkpoints checkpoints(setup.output, run.model.state.time, state);
  bool stopped = false;
  while (run.model.state.time < end && !stopped) {
    const double now = run.model.state.time;
    const double output = clock.next_output(now);
    const double event = std::min(output, run.model.conditions.next_break(now));
    const StepMade step = scheme.make_step(event);
    if (step.size >= event - now) {
      run.model.state.time = event;
    }
    ++run.summary.steps;
    stopped = stop();
    const bool at_output = clock.reaches(run.model.state.time, output);
    if (at_output || stopped || run.summary.steps % scheme.steps_between_checks == 0) {
      require_valid(run);
    }
    const double t = run.model.state.time;
    const StepEnd made{t,         run.summary.steps, history.due(t) || at_output,
                       at_output, t >= end,          stopped};
    checkpoints.report_step(
        made, [&] { report_history(run, step.size, observer); },
        [&] { report_frame(setup, run, observer); }, observer, run.execution);
    observer.on_progress(
        {t, end, step.size, run.summary.steps, step.iterations, reason(step, event, output)});
  }
}

}  // namespace percolith::simulation
