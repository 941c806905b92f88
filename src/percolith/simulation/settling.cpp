// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/settling.hpp"

#include "percolith/seepage/flow_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace percolith::simulation {
namespace {

using mesh::Index;

/// A change may pass through zero: a flow has settled where it is calm this often in a row.
constexpr std::int64_t calm_looks_wanted = 3;

/// Whether a schedule has another value than at `t` (s) at any later time until `end` (s).
bool is_to_change(const Schedule& schedule, double t, double end) {
  const double now = schedule.at(t);
  for (double next = schedule.next_break(t); next < end; next = schedule.next_break(next)) {
    if (schedule.at(next) != now) {
      return true;
    }
  }
  return schedule.at(end) != now;
}

bool is_to_change(const seepage::Conditions& conditions, double t, double end) {
  return std::any_of(conditions.schedule.begin(), conditions.schedule.end(),
                     [&](const Schedule& schedule) { return is_to_change(schedule, t, end); });
}

}  // namespace

Settling::Settling(const Stepping& time, const seepage::Model& model) : time_(time) {
  if (!is_wanted()) {
    return;
  }
  const seepage::FlowGraph graph = seepage::make_flow_graph(model);
  for (const double conductance : graph.conductance) {
    conductance_ += std::abs(conductance);
  }
  for (const double lift : graph.lift) {
    largest_lift_ = std::max(largest_lift_, std::abs(lift));
  }
  content_ = model.state.content;
  crack_content_ = model.state.crack_content;
}

double Settling::take_change(const seepage::Model& model) {
  double change = 0.0;
  for (const Index node : model.pore_nodes.nodes(model.mesh)) {
    change += std::abs(model.state.content[at(node)] - content_[at(node)]);
  }
  for (const Index v : model.cracks.open_nodes()) {
    change += std::abs(model.state.crack_content[at(v)] - crack_content_[at(v)]);
  }
  content_ = model.state.content;
  crack_content_ = model.state.crack_content;
  return change;
}

double Settling::round_off(const seepage::Model& model) const {
  double largest = largest_lift_;
  for (const Index node : model.pore_nodes.nodes(model.mesh)) {
    largest = std::max(largest, std::abs(model.state.pressure[at(node)]));
  }
  for (const Index v : model.cracks.open_nodes()) {
    largest = std::max(largest, std::abs(model.state.crack_pressure[at(v)]));
  }
  return std::numeric_limits<double>::epsilon() * largest * conductance_;
}

bool Settling::is_calm(const seepage::Model& model, double change, double through) {
  const double ratio = time_.stop_ratio.value_or(0.0);
  const double infinity = std::numeric_limits<double>::infinity();
  seen_ = {through > 0.0 ? change / through : (change > 0.0 ? infinity : 0.0), false};
  if (change <= ratio * through) {
    seen_.is_rest = through <= round_off(model);
    return true;
  }
  // Where water comes to rest both vanish together.
  const double mean_change = moved_ / model.state.time;
  seen_.is_rest = std::max(change, through) <= std::max(ratio * mean_change, round_off(model));
  return seen_.is_rest;
}

bool Settling::look(const seepage::Model& model) {
  const double since = model.state.time - looked_at_;
  const double change = take_change(model);
  const double in = model.passed_in.total();
  const double out = model.passed_out.total();
  const double through = std::max(in - passed_in_, out - passed_out_);
  passed_in_ = in;
  passed_out_ = out;
  looked_at_ = model.state.time;
  moved_ += change;
  const bool calm = is_calm(model, change / since, through / since) &&
                    !is_to_change(model.conditions, model.state.time, time_.end);
  calm_looks_ = calm ? calm_looks_ + 1 : 0;
  return calm_looks_ >= calm_looks_wanted;
}

void Settling::describe_state(StateArchive& archive) {
  archive("content", content_);
  archive("crack_content", crack_content_);
  archive("passed_in", passed_in_);
  archive("passed_out", passed_out_);
  archive("looked_at", looked_at_);
  archive("moved", moved_);
  archive("calm_looks", calm_looks_);
}

}  // namespace percolith::simulation
