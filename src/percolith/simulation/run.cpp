// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/run.hpp"

#include "percolith/core/error.hpp"
#include "percolith/seepage/steady_flow.hpp"
#include "percolith/simulation/balance.hpp"

#include <fmt/format.h>

namespace percolith::simulation {

void require_datum(const Setup& setup, const seepage::Model& model) {
  if (setup.time.scheme != Scheme::steady && !setup.initial.steady) {
    return;
  }
  const seepage::FlowGraph graph = seepage::make_flow_graph(model);
  const auto node =
      seepage::node_without_datum(graph, seepage::make_graph_conditions(model, graph));
  if (node) {
    const Point p = graph.place(model, *node);
    throw InputError({{},
                      setup.initial.steady ? "initial.steady" : "time.scheme",
                      setup.initial.steady ? "true" : "\"steady\"",
                      fmt::format("nothing fixes the pressure in the part of the model that holds "
                                  "the {} at ({:g}, {:g})",
                                  graph.kind(*node), p.x, p.y),
                      "a pressure, head or seepage_face on a boundary or fracture connected to "
                      "it, or a transient scheme"});
  }
}

void report_frame(const Setup& setup, RunState& run, Observer& observer) {
  const auto start = std::chrono::steady_clock::now();
  if (setup.output.fields) {
    observer.on_frame({run.model.state.time, run.summary.steps,
                       matrix_frame(run.model, setup.model.head_datum),
                       crack_frame(run.model, setup.model.head_datum)});
  }
  observer.on_probes(run.model.state.time, run.probes.read(run.model));
  run.execution.book("output", start);
}

void report_history(RunState& run, double step_size, Observer& observer) {
  const auto start = std::chrono::steady_clock::now();
  run.summary.last =
      history_row(run.model, mass_balance(run.model, run.in_place_at_start, run.execution));
  run.summary.last.step = run.summary.steps;
  run.summary.last.step_size = step_size;
  run.summary.throughput = run.model.rate_in;
  observer.on_history(run.summary.last);
  run.execution.book("output", start);
}

void require_valid(const RunState& run) {
  require_valid(run.model, run.summary.steps);
}

void require_valid(const seepage::Model& model, std::int64_t step, std::string_view more) {
  if (const auto place = find_invalid(model)) {
    throw SolverError(fmt::format(
        "the {} is not a number at time {:.9g} s (step {}); the results up to the last output are "
        "kept. Look for extreme or contradictory values near that place{}",
        *place, model.state.time, step, more));
  }
  if (const auto place = find_overdrawn(model)) {
    throw SolverError(fmt::format(
        "a source or flux takes more fluid than there is from the {} at time {:.9g} s (step {}); "
        "the results up to the last output are kept. Lower the rate that is taken there, or give a "
        "pressure in its place",
        *place, model.state.time, step));
  }
}

Summary finished_summary(const RunState& run) {
  Summary summary = run.summary;
  summary.end_time = run.model.state.time;
  summary.wall_time = {run.execution.wall_time().begin(), run.execution.wall_time().end()};
  summary.state_hash = hash_of(run.model.state);
  return summary;
}

void run_steady(const Setup& setup, RunState& run, Observer& observer) {
  const seepage::SteadyResult result = seepage::solve_steady(run.model, run.execution);
  require_valid(run);
  run.summary.steps = 1;
  run.summary.iterations = result.iterations;
  run.summary.throughput = result.throughput;
  run.summary.last =
      history_row(run.model, steady_balance(run.model, result.round_off, run.execution));
  run.summary.last.step = 1;
  observer.on_history(run.summary.last);
  report_frame(setup, run, observer);
}

}  // namespace percolith::simulation
