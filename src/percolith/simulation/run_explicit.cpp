// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/explicit_step.hpp"
#include "percolith/seepage/step_limit.hpp"
#include "percolith/simulation/run.hpp"
#include "percolith/time/step_control.hpp"

#include <algorithm>
#include <memory>

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
  const double stable = limits.empty() ? setup.time.end : setup.time.safety * limits.back().step;
  if (setup.time.step && *setup.time.step <= stable) {
    return {*setup.time.step, "given step"};
  }
  static constexpr const char* names[] = {"pore flow", "finite joints", "crack flow", "exchange"};
  for (const char* name : names) {
    if (!limits.empty() && limits.front().mechanism == name) {
      return {stable, name};
    }
  }
  return {std::min(stable, setup.time.end), "all together"};
}

}  // namespace

TransientScheme explicit_scheme(const Setup& setup, RunState& run) {
  const auto scheme = std::make_shared<seepage::ExplicitStep>(run.model);
  const Limit limit = explicit_limit(setup, run.model);
  const auto make_step = [&run, scheme, limit](double event) -> StepMade {
    const double dt = step_towards(run.model.state.time, event, limit.step);
    scheme->advance(run.model, dt, run.execution);
    return {dt, limit.step, 0, limit.ruled_by};
  };
  return {make_step, setup.time.end / 1000.0, steps_between_checks};
}

}  // namespace percolith::simulation
