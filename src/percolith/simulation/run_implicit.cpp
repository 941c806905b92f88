// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/error.hpp"
#include "percolith/seepage/implicit_flow.hpp"
#include "percolith/seepage/step_limit.hpp"
#include "percolith/simulation/run.hpp"
#include "percolith/time/step_control.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>

namespace percolith::simulation {
namespace {

/// Steps this much shorter than the first one, or than the time gone by, mean that no solution is
/// to be had. The end of the run is no measure: it may be as far off as anyone likes.
constexpr double smallest_share = 1e-15;

StepControl make_control(const Setup& setup, const seepage::ImplicitFlow& flow) {
  const Stepping& time = setup.time;
  if (time.step) {
    return {std::numeric_limits<double>::infinity(), *time.step, *time.step};
  }
  // Too large a first step is rejected, too small a one doubles at once: the limit of the explicit
  // scheme in the pores is the scale on which anything happens. Far below the limit of all
  // mechanisms together nothing is left to resolve, although the error of the first injection into
  // rock at one pressure stays the same share of the pressure it causes, however short the step.
  const std::vector<seepage::FlowLimit> limits = seepage::step_limits(flow.graph());
  double first = time.end;
  for (const seepage::FlowLimit& limit : limits) {
    if (limit.mechanism == "pore flow") {
      first = limit.step;
    }
  }
  const double smallest = limits.empty() ? 0.0 : 1e-3 * limits.back().step;
  return {time.tolerance, time.initial_step.value_or(first), time.maximum_step.value_or(time.end),
          smallest};
}

[[noreturn]] void give_up(const RunState& run, double dt) {
  throw SolverError(fmt::format(
      "the implicit step found no solution at time {:.9g} s even with a step of {:.3g} s; the "
      "results up to the last output are kept. Look for extreme values of permeability, aperture "
      "or "
      "rates, or for a rate that takes more fluid than there is",
      run.model.state.time, dt));
}

/// Tries steps until one is good and accepts it; `event` is not overstepped. `first` is the first
/// step of the run, s.
StepMade make_step(RunState& run, seepage::ImplicitFlow& flow, StepControl& control, double event,
                   double first, const char* limited_by) {
  const double shortest = smallest_share * std::max(first, run.model.state.time);
  while (true) {
    const double asked = control.step();
    const double dt = step_towards(run.model.state.time, event, asked);
    // An event close ahead may make a short step; only the step that is asked for means failure.
    if (asked < shortest) {
      give_up(run, dt);
    }
    const bool solved = flow.attempt(run.model, dt, run.execution);
    run.summary.iterations += flow.iterations();
    if (!solved) {
      control.failed(dt);
    } else if (control.judge(dt, flow.error())) {
      flow.accept(run.model);
      return {dt, asked, flow.iterations(), limited_by};
    }
    ++run.summary.rejected_steps;
  }
}

}  // namespace

TransientScheme implicit_scheme(const Setup& setup, RunState& run) {
  const auto flow = std::make_shared<seepage::ImplicitFlow>(run.model);
  const auto control = std::make_shared<StepControl>(make_control(setup, *flow));
  const char* limited_by = setup.time.step ? "given step" : "tolerance";
  const double first = std::min(control->step(), setup.time.end);
  TransientScheme scheme{[&run, flow, control, first, limited_by](double event) {
    return make_step(run, *flow, *control, event, first, limited_by);
  }};
  scheme.state = [flow, control](StateArchive& archive) {
    archive("flow", *flow);
    archive("control", *control);
  };
  return scheme;
}

}  // namespace percolith::simulation
