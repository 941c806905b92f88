// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/state.hpp"

#include "percolith/seepage/state.hpp"

namespace percolith::simulation {

static void describe_state(StateArchive& archive, MassBalance& balance) {
  archive("in", balance.in);
  archive("out", balance.out);
  archive("stored", balance.stored);
  archive("in_place", balance.in_place);
  archive("error", balance.error);
  archive("relative_error", balance.relative_error);
  archive("by_condition", balance.by_condition);
}

static void describe_state(StateArchive& archive, HistoryRow& row) {
  archive("time", row.time);
  archive("step", row.step);
  archive("step_size", row.step_size);
  archive("minimum_pressure", row.minimum_pressure);
  archive("maximum_pressure", row.maximum_pressure);
  archive("minimum_crack_pressure", row.minimum_crack_pressure);
  archive("maximum_crack_pressure", row.maximum_crack_pressure);
  archive("minimum_saturation", row.minimum_saturation);
  archive("balance", row.balance);
  archive("rate", row.rate);
  archive.of_any_size("mechanics", row.mechanics);
}

static void describe_state(StateArchive& archive, PeakReaction& peak) {
  archive("name", peak.name);
  archive("x", peak.x);
  archive("y", peak.y);
  archive("x_time", peak.x_time);
  archive("y_time", peak.y_time);
}

static void describe_state(StateArchive& archive, PeakPressure& peak) {
  archive("name", peak.name);
  archive("pressure", peak.pressure);
  archive("time", peak.time);
}

static void describe_state(StateArchive& archive, Settlement& settlement) {
  archive("change", settlement.change);
  archive("is_rest", settlement.is_rest);
}

void describe_state(StateArchive& archive, Summary& summary) {
  archive("steps", summary.steps);
  archive("rejected_steps", summary.rejected_steps);
  archive("iterations", summary.iterations);
  archive("last", summary.last);
  archive("throughput", summary.throughput);
  archive("reached_rest", summary.reached_rest);
  archive("settlement", summary.settlement);
  archive.of_any_size("peak_reactions", summary.peak_reactions);
  archive.of_any_size("peak_pressures", summary.peak_pressures);
}

void describe_state(StateArchive& archive, RunState& run) {
  archive("model", run.model);
  archive("in_place_at_start", run.in_place_at_start);
  archive("summary", run.summary);
}

static void describe_state(StateArchive& archive, BrokenJoints& broken) {
  archive("mode", broken.mode);
  archive("time", broken.time);
  archive("released", broken.released);
  archive.of_any_size("magnitude", broken.magnitude);
  archive("count", broken.count);
}

void describe_state(StateArchive& archive, SolidRun& run) {
  archive("dynamics", run.dynamics);
  archive("broken", run.broken);
  archive("deepest_overlap", run.deepest_overlap);
  archive("summary", run.summary);
  if (archive.reads()) {
    run.fragments_stale = true;
  }
}

}  // namespace percolith::simulation
