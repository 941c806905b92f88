// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/run.hpp"
#include "percolith/simulation/state.hpp"

#include <algorithm>
#include <utility>

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

TransientRun::TransientRun(const Setup& setup, RunState& run, TransientScheme scheme)
    : setup_(setup), run_(run), scheme_(std::move(scheme)), clock_(setup.output, setup.time.end),
      history_(setup.output.history_interval.value_or(scheme_.history_interval)),
      settling_(setup.time, run.model) {}

void TransientRun::describe_state(StateArchive& archive) {
  archive("run", run_);
  archive("history", history_);
  archive("settling", settling_);
  if (scheme_.state) {
    scheme_.state(archive);
  }
}

void TransientRun::begin(Observer& observer) {
  report_frame(setup_, run_, observer);
  if (history_.due(0.0)) {
    report_history(run_, 0.0, observer);
  }
  last_ = {.time = 0.0, .row = true, .frame = true};
  checkpoints_.emplace(setup_.output, 0.0,
                       [this](StateArchive& archive) { describe_state(archive); });
}

void TransientRun::begin_from(StateArchive& state, Observer& observer) {
  describe_state(state);
  observer.on_resume(run_.model.state.time, run_.summary.steps);
  last_ = {.time = run_.model.state.time, .number = run_.summary.steps, .row = true, .frame = true};
  checkpoints_.emplace(setup_.output, last_.time,
                       [this](StateArchive& archive) { describe_state(archive); });
}

StepMade TransientRun::make_step(double event) {
  const double now = run_.model.state.time;
  const StepMade step = scheme_.make_step(event);
  if (step.size >= event - now) {
    run_.model.state.time = event;
  }
  ++run_.summary.steps;
  size_ = step.size;
  return step;
}

void TransientRun::look_for_rest() {
  if (settling_.is_wanted() && run_.summary.steps % scheme_.steps_between_checks == 0) {
    run_.summary.reached_rest = settling_.look(run_.model);
    run_.summary.settlement = settling_.seen();
  }
}

bool TransientRun::is_over() const {
  return run_.model.state.time >= setup_.time.end || run_.summary.reached_rest;
}

void TransientRun::report_step(Observer& observer) {
  checkpoints_->report_step(
      last_, [&] { report_history(run_, size_, observer); },
      [&] { report_frame(setup_, run_, observer); }, observer, run_.execution);
}

Reached TransientRun::advance(Observer& observer, const std::function<bool()>& stop,
                              const Pause& pause) {
  const double end = setup_.time.end;
  const PauseClock wait(pause, run_.summary.steps);
  bool stopped = false;
  while (!is_over() && !stopped &&
         !wait.over(run_.model.state.time, run_.summary.steps, last_.frame)) {
    const double now = run_.model.state.time;
    const double output = clock_.next_output(now);
    const double event = std::min(output, run_.model.conditions.next_break(now));
    const StepMade step = make_step(event);
    look_for_rest();
    stopped = stop();
    const double t = run_.model.state.time;
    const bool at_output = clock_.reaches(t, output) || run_.summary.reached_rest;
    if (at_output || stopped || run_.summary.steps % scheme_.steps_between_checks == 0) {
      require_valid(run_);
    }
    last_ = {t, run_.summary.steps, history_.due(t) || at_output, at_output, is_over(), stopped};
    report_step(observer);
    observer.on_progress(
        {t, end, step.size, run_.summary.steps, step.iterations, reason(step, event, output)});
  }
  if (is_over()) {
    return Reached::end;
  }
  return stopped ? Reached::stop : Reached::pause;
}

void TransientRun::leave(Observer& observer) {
  checkpoints_->report_stop(
      last_, [&] { report_history(run_, size_, observer); },
      [&] { report_frame(setup_, run_, observer); }, observer, run_.execution);
}

}  // namespace percolith::simulation
