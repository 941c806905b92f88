// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/explicit_step.hpp"
#include "percolith/seepage/step_limit.hpp"
#include "percolith/simulation/event_clock.hpp"
#include "percolith/simulation/run.hpp"
#include "percolith/time/step_control.hpp"

#include <algorithm>

namespace percolith::simulation {
namespace {

/// A value that is not a number spreads; looking for it every so many steps finds it soon enough.
constexpr std::int64_t steps_between_checks = 200;

struct Limit {
  double step;
  const char* ruled_by;
};

Limit explicit_limit(const Setup& setup, const seepage::Model& model) {
  const auto limits = seepage::step_limits(seepage::make_flow_graph(model));
  const double stable = setup.time.safety * limits.back().step;
  if (setup.time.step && *setup.time.step <= stable) {
    return {*setup.time.step, "given step"};
  }
  static constexpr const char* names[] = {"pore flow", "finite joints", "crack flow", "exchange"};
  for (const char* name : names) {
    if (limits.front().mechanism == name) {
      return {stable, name};
    }
  }
  return {std::min(stable, setup.time.end), "all together"};
}

}  // namespace

void run_explicit(const Setup& setup, RunState& run, Observer& observer,
                  const std::function<bool()>& stop) {
  seepage::ExplicitStep scheme(run.model);
  const Limit limit = explicit_limit(setup, run.model);
  const double end = setup.time.end;
  const EventClock clock(setup.output, end);
  HistoryClock history(setup.output.history_interval.value_or(end / 1000.0));
  report_frame(setup, run, observer);
  if (history.due(0.0)) {
    report_history(run, 0.0, observer);
  }
  bool stopped = false;
  while (run.model.state.time < end && !stopped) {
    const double now = run.model.state.time;
    const double output = clock.next_output(now);
    const double event = std::min(output, run.model.conditions.next_break(now));
    const double dt = step_towards(now, event, limit.step);
    scheme.advance(run.model, dt, run.execution);
    if (dt >= event - now) {
      run.model.state.time = event;
    }
    ++run.summary.steps;
    if (run.summary.steps % steps_between_checks == 0) {
      require_valid(run);
    }
    stopped = stop();
    const bool at_output = run.model.state.time == output || stopped;
    if (at_output) {
      require_valid(run);
    }
    if (history.due(run.model.state.time) || at_output) {
      report_history(run, dt, observer);
    }
    if (at_output) {
      report_frame(setup, run, observer);
    }
    observer.on_progress({run.model.state.time, end, dt, run.summary.steps, 0, limit.ruled_by});
  }
}

}  // namespace percolith::simulation
