// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/execution.hpp"
#include "percolith/mesh/mesh.hpp"
#include "percolith/seepage/model.hpp"

#include <span>
#include <vector>

namespace percolith::seepage {

/// The flow problem as a graph, for schemes that solve for all pressures at once: a node per group
/// of pore and crack nodes that share one pressure, an edge per conductance. Crack nodes share the
/// pressure of the pore nodes they face where the exchange coefficient is infinite; elsewhere
/// every pore and crack node is a node of its own.
struct FlowGraph {
  /// Members of each node: a leader corner c as c, a crack vertex v as -1 - v. Ascending.
  mesh::IndexTable members;
  std::vector<Index> node_of_corner;  ///< of leaders; `none` elsewhere
  std::vector<Index> node_of_vertex;  ///< of open crack nodes; `none` elsewhere
  std::vector<double> storage;        ///< m2/Pa
  std::vector<double> void_volume;    ///< m2
  std::vector<double> lift;           ///< rho_w g y, Pa

  /// Ends of the edges. Those below `triangle_edges` come in threes, the pairs of one triangle;
  /// then, up to the number named, finite joints, joints along cracks, and exchange.
  std::vector<Index> from, to;
  std::vector<double> conductance;  ///< m2/(Pa s)
  Index triangle_edges = 0;
  Index joint_edges = 0;
  Index crack_edges = 0;
  /// Edges at each node: edge e as 2 e at its `from` end and 2 e + 1 at its `to` end.
  mesh::IndexTable incidence;

  [[nodiscard]] Index nodes() const { return static_cast<Index>(storage.size()); }
  [[nodiscard]] Index edges() const { return static_cast<Index>(from.size()); }
  [[nodiscard]] Point place(const Model& model, Index node) const;
  /// "pore node" or "crack node", for messages.
  [[nodiscard]] const char* kind(Index node) const;
};

[[nodiscard]] FlowGraph make_flow_graph(const Model& model);
/// The crack network alone: the open crack nodes, then the pore nodes their faces belong to, with
/// the joints along cracks and the exchange between both.
[[nodiscard]] FlowGraph make_crack_graph(const Model& model);
/// Brings volumes of all nodes and conductances along cracks up to date with the openings of the
/// cracks and the growth of the pores.
void refresh_graph(const Model& model, FlowGraph& graph);

/// Pressure, saturation and excess of every node of a graph. The pressure is `pressure + change`:
/// a small change on a large pressure keeps its digits, and so do the flows it drives.
struct GraphState {
  std::vector<double> pressure;         ///< Pa
  std::vector<double> change;           ///< Pa
  std::vector<double> saturation;       ///< 1
  std::vector<CompensatedSum> content;  ///< m2: excess over the present voids
};

/// Copies the state of the model into the numbering of the graph.
[[nodiscard]] GraphState gather_state(const Model& model, const FlowGraph& graph);
/// Which part of the content `whole` (m2) of a node a member of it has: by storage where the node
/// is full, by volume where it is partly empty.
[[nodiscard]] CompensatedSum content_of_member(const Model& model, const FlowGraph& graph,
                                               Index node, Index member,
                                               const CompensatedSum& whole);
/// Gives the contents of the graph back to the model and derives pressures and saturations; nodes
/// that share a pressure share their content accordingly.
void scatter_contents(Model& model, const FlowGraph& graph,
                      std::span<const CompensatedSum> content);

/// Which edges carry how much of their conductance: the saturation weight of each edge (m2/(Pa s)
/// times weight) at the present pressures and saturations.
void weighted_conductances(const FlowGraph& graph, const GraphState& state, SaturationWeight how,
                           bool saturated, std::span<double> result);

/// Flow (m2/s) of every edge from `from` to `to` with given weighted conductances.
void edge_flows(const FlowGraph& graph, const GraphState& state,
                std::span<const double> conductance, std::span<double> flow);
/// Inflow (m2/s) of every node, gathered from its edges in ascending order.
void node_inflows(const FlowGraph& graph, std::span<const double> flow, std::span<double> inflow);

}  // namespace percolith::seepage
