// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/event_clock.hpp"
#include "percolith/simulation/run.hpp"

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
                   const std::function<bool()>& stop, const TransientScheme& scheme) {
  const double end = setup.time.end;
  const EventClock clock(setup.output, end);
  HistoryClock history(setup.output.history_interval.value_or(scheme.history_interval));
  report_frame(setup, run, observer);
  if (history.due(0.0)) {
    report_history(run, 0.0, observer);
  }
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
    const bool at_output = clock.reaches(run.model.state.time, output) || stopped;
    if (at_output || run.summary.steps % scheme.steps_between_checks == 0) {
      require_valid(run);
    }
    if (history.due(run.model.state.time) || at_output) {
      report_history(run, step.size, observer);
    }
    if (at_output) {
      report_frame(setup, run, observer);
    }
    observer.on_progress({run.model.state.time, end, step.size, run.summary.steps, step.iterations,
                          reason(step, event, output)});
  }
}

}  // namespace percolith::simulation
