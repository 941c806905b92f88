// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/flow_graph.hpp"

#include "percolith/seepage/content.hpp"

namespace percolith::seepage {
namespace {

/// Potential difference from node a to node b, Pa, as differences of what is equal in size.
double potential_difference(const FlowGraph& graph, const GraphState& state, Index a, Index b) {
  return ((state.pressure[at(a)] - state.pressure[at(b)]) +
          (graph.lift[at(a)] - graph.lift[at(b)])) +
         (state.change[at(a)] - state.change[at(b)]);
}

}  // namespace

GraphState gather_state(const Model& model, const FlowGraph& graph) {
  const auto nodes = at(graph.nodes());
  GraphState state;
  state.pressure.resize(nodes);
  state.saturation.resize(nodes);
  state.change.assign(nodes, 0.0);
  state.content.resize(nodes);
  for (std::size_t n = 0; n < nodes; ++n) {
    const auto members = graph.members.row(static_cast<Index>(n));
    for (const Index m : members) {
      const bool crack = m < 0;
      const auto i = at(crack ? -1 - m : m);
      const State& s = model.state;
      state.content[n] += crack ? s.crack_content[i] : s.content[i] - s.growth[i];
      state.content[n].carry += crack ? s.crack_content_carry[i] : s.content_carry[i];
      state.pressure[n] = crack ? s.crack_pressure[i] : s.pressure[i];
      state.saturation[n] = crack ? s.crack_saturation[i] : s.saturation[i];
    }
    if (members.size() > 1) {
      const auto fluid =
          fluid_state(state.content[n].total(), 0.0, graph.storage[n], graph.void_volume[n],
                      model.reference_pressure(), model.can_empty());
      state.pressure[n] = fluid.pressure;
      state.saturation[n] = fluid.saturation;
    }
  }
  return state;
}

CompensatedSum content_of_member(const Model& model, const FlowGraph& graph, Index node,
                                 Index member, const CompensatedSum& whole) {
  if (graph.members.row(node).size() == 1) {
    return whole;
  }
  const Index vertex = -1 - member;
  const bool crack = member < 0;
  double share = 0.0;
  if (model.can_empty() && whole.total() < 0.0) {
    share = (crack ? model.crack.void_volume[at(vertex)]
                   : model.state.void_volume[at(member)] + model.state.growth[at(member)]) /
            graph.void_volume[at(node)];
  } else {
    share = (crack ? model.crack_storage(vertex) : model.state.storage[at(member)]) /
            graph.storage[at(node)];
  }
  return {share * whole.value, share * whole.carry};
}

void scatter_contents(Model& model, const FlowGraph& graph,
                      std::span<const CompensatedSum> content) {
  for (Index n = 0; n < graph.nodes(); ++n) {
    for (const Index m : graph.members.row(n)) {
      CompensatedSum part = content_of_member(model, graph, n, m, content[at(n)]);
      if (m < 0) {
        set_crack_content(model, -1 - m, part);
      } else {
        part += model.state.growth[at(m)];
        set_pore_content(model, m, part);
      }
    }
  }
}

void weighted_conductances(const FlowGraph& graph, const GraphState& state, SaturationWeight how,
                           bool saturated, std::span<double> result) {
  for (Index e = 0; e < graph.edges(); ++e) {
    double weight = 1.0;
    if (!saturated) {
      if (how == SaturationWeight::mean && e < graph.triangle_edges) {
        const auto first = at(e - e % 3);
        weight = saturation_weight((state.saturation[at(graph.from[first])] +
                                    state.saturation[at(graph.from[first + 1])] +
                                    state.saturation[at(graph.from[first + 2])]) /
                                   3.0);
      } else {
        const Index a = graph.from[at(e)];
        const Index b = graph.to[at(e)];
        const double drive = graph.conductance[at(e)] * potential_difference(graph, state, a, b);
        weight = saturation_weight(state.saturation[at(drive > 0.0 ? a : b)]);
      }
    }
    result[at(e)] = weight * graph.conductance[at(e)];
  }
}

void edge_flows(const FlowGraph& graph, const GraphState& state,
                std::span<const double> conductance, std::span<double> flow) {
  for (Index e = 0; e < graph.edges(); ++e) {
    flow[at(e)] =
        conductance[at(e)] * potential_difference(graph, state, graph.from[at(e)], graph.to[at(e)]);
  }
}

void node_inflows(const FlowGraph& graph, std::span<const double> flow, std::span<double> inflow) {
  for (Index n = 0; n < graph.nodes(); ++n) {
    double sum = 0.0;
    for (const Index entry : graph.incidence.row(n)) {
      sum += entry % 2 == 0 ? -flow[at(entry / 2)] : flow[at(entry / 2)];
    }
    inflow[at(n)] = sum;
  }
}

}  // namespace percolith::seepage
