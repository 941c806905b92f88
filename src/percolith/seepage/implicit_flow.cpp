// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/implicit_flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace percolith::seepage {
namespace {

constexpr int most_corrections = 60;
constexpr double saturation_tolerance = 1e-9;
/// A front that fills a void is resolved by the mesh, not by the step: an error of saturation
/// counts this much of an error of pressure.
constexpr double saturation_share = 0.02;

}  // namespace

ImplicitFlow::ImplicitFlow(const Model& model, Network network)
    : graph_(network == Network::all ? make_flow_graph(model) : make_crack_graph(model)),
      conditions_(network == Network::all ? make_graph_conditions(model, graph_)
                                          : make_crack_conditions(model, graph_)),
      system_(graph_, conditions_.prescribed), active_(graph_), conductance_(graph_.conductance),
      storage_rate_(at(graph_.nodes())), source_(at(graph_.nodes())), rate_(at(graph_.nodes())),
      flow_(graph_.from.size()), inflow_(at(graph_.nodes())), content_(at(graph_.nodes())),
      previous_rate_(at(graph_.nodes()), 0.0) {}

void ImplicitFlow::refresh(const Model& model) {
  refresh_graph(model, graph_);
  factorised_dt_ = 0.0;
}

bool ImplicitFlow::attempt(const Model& model, double dt, Execution& execution) {
  return attempt(model, model.state.time, dt, execution);
}

bool ImplicitFlow::attempt(const Model& model, double t, double dt, Execution& execution,
                           std::span<const double> compliance) {
  prepare(model, t, dt);
  for (std::size_t n = 0; n < compliance.size(); ++n) {
    storage_rate_[n] += compliance[n] / dt;
    source_[n] += compliance[n] / dt * (start_.pressure[n] - model.reference_pressure());
  }
  if (!iterate(model, dt, execution)) {
    factorised_dt_ = 0.0;
    return false;
  }
  finish(model, dt);
  estimate_error(model, dt);
  return true;
}

void ImplicitFlow::prepare(const Model& model, double t, double dt) {
  time_ = t;
  dt_ = dt;
  start_ = gather_state(model, graph_);
  state_ = start_;
  active_.start(model, graph_, start_);
  std::fill(rate_.begin(), rate_.end(), 0.0);
  booked_.clear();
  const double middle = t + 0.5 * dt;
  for (const GraphCondition& c : conditions_.rate) {
    const double rate = model.conditions.value(c.condition, middle);
    rate_[at(c.node)] += rate;
    booked_.push_back({c.condition.condition, c.vertex, rate * dt});
  }
  const double end = last_moment(t + dt);
  for (const GraphCondition& c : conditions_.pressure) {
    state_.pressure[at(c.node)] = model.conditions.value(c.condition, end);
    state_.saturation[at(c.node)] = 1.0;
  }
  for (std::size_t n = 0; n < source_.size(); ++n) {
    storage_rate_[n] = graph_.storage[n] / dt;
    source_[n] = start_.content[n].total() / dt + rate_[n];
  }
}

bool ImplicitFlow::iterate(const Model& model, double dt, Execution& execution) {
  const double end = last_moment(time_ + dt);
  const double reference = model.reference_pressure();
  for (iterations_ = 1; iterations_ <= most_corrections; ++iterations_) {
    const bool linear = !active_.any_empty() && conditions_.seepage_face.empty();
    active_.hold(model, conditions_, end, state_);
    if (linear && factorised_dt_ == dt) {
      std::copy(graph_.conductance.begin(), graph_.conductance.end(), conductance_.begin());
    } else {
      const auto start = std::chrono::steady_clock::now();
      weighted_conductances(graph_, state_, model.weight, !active_.any_empty(), conductance_);
      if (!system_.assemble(graph_, conductance_, storage_rate_, active_.held())) {
        return false;
      }
      factorised_dt_ = linear ? dt : 0.0;
      execution.book("factorisation", start);
    }
    const auto start = std::chrono::steady_clock::now();
    if (!system_.solve(graph_, conductance_, storage_rate_, source_, reference, state_)) {
      return false;
    }
    edge_flows(graph_, state_, conductance_, flow_);
    node_inflows(graph_, flow_, inflow_);
    execution.book("solution", start);
    bool changed =
        active_.update_faces(model, conditions_, end, source_, storage_rate_, inflow_, state_);
    double moved = 0.0;
    if (model.can_empty()) {
      changed = active_.update_saturations(model, graph_, conditions_, dt, start_.content, rate_,
                                           conductance_, state_, moved) ||
                changed;
    }
    if (!changed && moved < saturation_tolerance) {
      return true;
    }
  }
  return false;
}

void ImplicitFlow::finish(const Model& model, double dt) {
  const double end = last_moment(time_ + dt);
  for (std::size_t n = 0; n < content_.size(); ++n) {
    content_[n] = start_.content[n];
    content_[n] += dt * (inflow_[n] + rate_[n]);
  }
  // Where the pressure is given the condition supplies what the flows leave open.
  const auto supply = [&](const GraphCondition& c) {
    const auto n = at(c.node);
    const double pressure = model.conditions.value(c.condition, end);
    const double target = graph_.storage[n] * (pressure - model.reference_pressure());
    booked_.push_back(
        {c.condition.condition, c.vertex, (target - content_[n].value) - content_[n].carry});
    content_[n] = {target, 0.0};
  };
  for (const GraphCondition& c : conditions_.pressure) {
    supply(c);
  }
  for (const GraphCondition& c : conditions_.seepage_face) {
    if (active_.is_open_face(c.node)) {
      supply(c);
    }
  }
}

void ImplicitFlow::estimate_error(const Model& model, double dt) {
  double low = 0.0;
  double high = 0.0;
  for (std::size_t n = 0; n < content_.size(); ++n) {
    const double pressure = state_.pressure[n];
    low = n == 0 ? pressure : std::min(low, pressure);
    high = n == 0 ? pressure : std::max(high, pressure);
  }
  const double range = std::max(high - low, 1e-12 * std::max(std::abs(low), std::abs(high)));
  double sum[2] = {0.0, 0.0};
  double weight[2] = {0.0, 0.0};
  const double share = previous_dt_ > 0.0 ? dt / (dt + previous_dt_) : 0.5;
  for (Index node = 0; node < graph_.nodes(); ++node) {
    const auto n = at(node);
    if (conditions_.prescribed[n] != 0) {
      continue;
    }
    const double rate = (content_[n].total() - start_.content[n].total()) / dt;
    const double disagreement = share * dt * (rate - previous_rate_[n]);
    const bool full = !active_.is_empty(node) && start_.saturation[n] >= 1.0;
    const double scale =
        full ? graph_.storage[n] * range : graph_.void_volume[n] / saturation_share;
    const double error = scale > 0.0 ? disagreement / scale : 0.0;
    const std::size_t field = graph_.members.row(node).back() < 0 ? 1 : 0;
    sum[field] += graph_.void_volume[n] * error * error;
    weight[field] += graph_.void_volume[n];
  }
  error_ = 0.0;
  for (std::size_t field = 0; field < 2; ++field) {
    if (weight[field] > 0.0) {
      error_ = std::max(error_, std::sqrt(sum[field] / weight[field]));
    }
  }
  if (!model.can_empty() && range == 0.0) {
    error_ = 0.0;
  }
}

void ImplicitFlow::accept(Model& model) {
  apply(model);
  book_step(model, booked_, dt_);
  model.state.time += dt_;
}

double ImplicitFlow::leaked_from_cracks(const Model& model) const {
  double sum = 0.0;
  for (auto e = at(graph_.crack_edges); e < flow_.size(); ++e) {
    // The edge runs from the face to the crack.
    sum -= flow_[e];
  }
  return sum * dt_ + leaked_at_shared_pressure(model);
}

double ImplicitFlow::leaked_at_shared_pressure(const Model& model) const {
  const auto is_shared = [&](Index node) {
    return node != mesh::none && graph_.members.row(node).size() > 1 &&
           conditions_.prescribed[at(node)] == 0 && !active_.is_open_face(node);
  };
  double leaked = 0.0;
  for (const Index v : model.cracks.open_nodes()) {
    const Index node = graph_.node_of_vertex[at(v)];
    if (!is_shared(node)) {
      continue;
    }
    double came = 0.0;  // m2/s, along the cracks and through faces with a pressure of their own
    for (const Index entry : graph_.incidence.row(node)) {
      if (entry / 2 >= graph_.joint_edges) {
        came += entry % 2 == 0 ? -flow_[at(entry / 2)] : flow_[at(entry / 2)];
      }
    }
    CompensatedSum kept = content_of_member(model, graph_, node, -1 - v, content_[at(node)]);
    kept += -model.state.crack_content[at(v)];
    kept += -model.state.crack_content_carry[at(v)];
    leaked += dt_ * came - kept.total();
  }
  for (const NodeCondition& c : model.conditions.crack.rate) {
    if (is_shared(graph_.node_of_vertex[at(c.place)])) {
      leaked += model.conditions.value(c, time_ + 0.5 * dt_) * dt_;
    }
  }
  return leaked;
}

void ImplicitFlow::show_pressures(Model& model) const {
  for (Index n = 0; n < graph_.nodes(); ++n) {
    const double pressure = state_.pressure[at(n)] + state_.change[at(n)];
    for (const Index m : graph_.members.row(n)) {
      if (m < 0) {
        model.state.crack_pressure[at(-1 - m)] = pressure;
        model.state.crack_saturation[at(-1 - m)] = state_.saturation[at(n)];
        continue;
      }
      model.pore_nodes.for_each_corner(model.mesh, m, [&](Index corner) {
        model.state.pressure[at(corner)] = pressure;
        model.state.saturation[at(corner)] = state_.saturation[at(n)];
      });
    }
  }
}

void ImplicitFlow::apply(Model& model) {
  for (std::size_t n = 0; n < content_.size(); ++n) {
    previous_rate_[n] = (content_[n].total() - start_.content[n].total()) / dt_;
  }
  previous_dt_ = dt_;
  scatter_contents(model, graph_, content_);
}

}  // namespace percolith::seepage
