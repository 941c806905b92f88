// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/active_set.hpp"

#include <algorithm>
#include <cmath>

namespace percolith::seepage {
namespace {

double pressure_of(const GraphState& state, Index node) {
  return state.pressure[at(node)] + state.change[at(node)];
}

/// Inflow of a partly empty node from donors above it, and what it would give away when full.
struct Exchange {
  double in = 0.0;   // m2/s
  double out = 0.0;  // m2/s, before the weight of the node's own saturation
};

Exchange exchange_of(const Model& model, const FlowGraph& graph, const GraphState& state,
                     std::span<const double> conductance, Index node) {
  Exchange sum;
  for (const Index entry : graph.incidence.row(node)) {
    const auto e = at(entry / 2);
    const Index other = entry % 2 == 0 ? graph.to[e] : graph.from[e];
    const double potential = ((state.pressure[at(other)] - state.pressure[at(node)]) +
                              (graph.lift[at(other)] - graph.lift[at(node)])) +
                             (state.change[at(other)] - state.change[at(node)]);
    if (model.weight == SaturationWeight::mean && entry / 2 < graph.triangle_edges) {
      sum.in += conductance[e] * potential;
      continue;
    }
    const double inflow = graph.conductance[e] * potential;
    if (inflow > 0.0) {
      sum.in += inflow * saturation_weight(state.saturation[at(other)]);
    } else {
      sum.out -= inflow;
    }
  }
  return sum;
}

/// Saturation s in [.., 1] with volume (s - 1) = content + dt (in - f(s) out): the left side grows
/// and the right side falls with s, so bisection cannot miss. `volume` in m2.
double solve_saturation(double volume, double content, double dt, const Exchange& exchange) {
  const auto excess = [&](double s) {
    return volume * (s - 1.0) - content -
           dt * (exchange.in - saturation_weight(std::clamp(s, 0.0, 1.0)) * exchange.out);
  };
  if (exchange.out == 0.0) {
    return 1.0 + (content + dt * exchange.in) / volume;
  }
  if (excess(1.0) <= 0.0) {
    return 1.0 - excess(1.0) / volume;
  }
  double low = std::min(0.0, 1.0 + (content + dt * std::min(exchange.in, 0.0)) / volume);
  double high = 1.0;
  for (int i = 0; i < 64 && high - low > 1e-16; ++i) {
    const double middle = 0.5 * (low + high);
    (excess(middle) < 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double pressure_tolerance(const GraphState& state, double reference_pressure) {
  double largest = 0.0;
  for (std::size_t n = 0; n < state.pressure.size(); ++n) {
    largest = std::max(largest, std::abs(state.pressure[n] - reference_pressure));
  }
  return 1e-9 * largest;
}

void ActiveSet::set_empty(Index node, bool empty) {
  if ((empty_[at(node)] != 0) != empty) {
    empties_ += empty ? 1 : -1;
  }
  empty_[at(node)] = empty ? 1 : 0;
  held_[at(node)] = empty || face_open_[at(node)] != 0 ? 1 : 0;
}

void ActiveSet::start(const Model& model, const FlowGraph& graph, const GraphState& state) {
  const double tolerance = pressure_tolerance(state, model.reference_pressure());
  for (Index n = 0; n < graph.nodes(); ++n) {
    set_empty(n, model.can_empty() &&
                     state.content[at(n)].total() < -tolerance * graph.storage[at(n)] &&
                     state.saturation[at(n)] < 1.0);
  }
}

bool ActiveSet::open_faces(const GraphConditions& conditions) {
  for (const GraphCondition& face : conditions.seepage_face) {
    face_open_[at(face.node)] = 1;
    held_[at(face.node)] = 1;
  }
  return !conditions.seepage_face.empty();
}

void ActiveSet::hold(const Model& model, const GraphConditions& conditions, double time,
                     GraphState& state) const {
  if (empties_ > 0) {
    for (std::size_t n = 0; n < empty_.size(); ++n) {
      if (empty_[n] != 0) {
        state.pressure[n] = model.reference_pressure();
        state.change[n] = 0.0;
      }
    }
  }
  for (const GraphCondition& face : conditions.seepage_face) {
    if (face_open_[at(face.node)] != 0) {
      state.pressure[at(face.node)] = model.conditions.value(face.condition, time);
      state.change[at(face.node)] = 0.0;
    }
  }
}

bool ActiveSet::update_faces(const Model& model, const GraphConditions& conditions, double time,
                             std::span<const double> source, std::span<const double> storage_rate,
                             std::span<const double> inflow, const GraphState& state) {
  bool changed = false;
  for (const GraphCondition& face : conditions.seepage_face) {
    const auto n = at(face.node);
    const double outside = model.conditions.value(face.condition, time);
    const bool open = face_open_[n] != 0;
    if (open) {
      const double stored = storage_rate[n] * (outside - model.reference_pressure());
      const double enters = stored - source[n] - inflow[n];
      // A face that would have to let fluid in closes; round-off of the flows does not count.
      const double noise = 1e-12 * (std::abs(stored) + std::abs(source[n]) + std::abs(inflow[n]));
      face_open_[n] = enters > noise ? 0 : 1;
    } else {
      face_open_[n] =
          pressure_of(state, face.node) > outside + pressure_tolerance(state, outside) ? 1 : 0;
    }
    if ((face_open_[n] != 0) != open) {
      changed = true;
      set_empty(face.node, false);
    }
  }
  return changed;
}

bool ActiveSet::update_saturations(const Model& model, const FlowGraph& graph,
                                   const GraphConditions& conditions, double dt,
                                   std::span<const CompensatedSum> content_before,
                                   std::span<const double> rate,
                                   std::span<const double> conductance, GraphState& state,
                                   double& largest_change) {
  bool changed = false;
  largest_change = 0.0;
  const double reference = model.reference_pressure();
  const double tolerance = pressure_tolerance(state, reference);
  std::vector<Index> order;
  for (Index n = 0; n < graph.nodes(); ++n) {
    if (conditions.prescribed[at(n)] != 0 || face_open_[at(n)] != 0) {
      state.saturation[at(n)] = 1.0;
    } else if (is_empty(n)) {
      order.push_back(n);
    } else if (pressure_of(state, n) < reference - tolerance) {
      set_empty(n, true);
      changed = true;
    } else {
      state.saturation[at(n)] = 1.0;
    }
  }
  // From the highest potential downwards each donor is known before its receiver.
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return std::pair(-graph.lift[at(a)], a) < std::pair(-graph.lift[at(b)], b);
  });
  for (const Index n : order) {
    const double before = state.saturation[at(n)];
    Exchange exchange = exchange_of(model, graph, state, conductance, n);
    exchange.in += rate[at(n)];
    const double s =
        solve_saturation(graph.void_volume[at(n)], content_before[at(n)].total(), dt, exchange);
    if (s > 1.0) {
      set_empty(n, false);
      changed = true;
    }
    state.saturation[at(n)] = std::min(s, 1.0);
    largest_change = std::max(largest_change, std::abs(state.saturation[at(n)] - before));
  }
  return changed;
}

}  // namespace percolith::seepage
