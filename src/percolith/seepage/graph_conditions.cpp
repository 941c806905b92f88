// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/graph_conditions.hpp"

namespace percolith::seepage {
namespace {

template <class NodeOf, class VertexOf>
void add_once(const std::vector<NodeCondition>& from, const NodeOf& node_of,
              const VertexOf& vertex_of, std::vector<std::uint8_t>& taken,
              std::vector<GraphCondition>& to) {
  for (const NodeCondition& c : from) {
    const Index node = node_of(c.place);
    if (node != mesh::none && taken[at(node)] == 0) {
      taken[at(node)] = 1;
      to.push_back({node, vertex_of(c.place), c});
    }
  }
}

void add_crack_rates(const Model& model, const FlowGraph& graph, GraphConditions& result) {
  for (const NodeCondition& c : model.conditions.crack.rate) {
    const Index node = graph.node_of_vertex[at(c.place)];
    if (node != mesh::none) {
      result.rate.push_back({node, c.place, c});
    }
  }
}

}  // namespace

GraphConditions make_crack_conditions(const Model& model, const FlowGraph& graph) {
  const auto of_vertex = [&](Index v) { return graph.node_of_vertex[at(v)]; };
  const auto at_vertex = [](Index v) { return v; };
  GraphConditions result;
  result.prescribed.assign(at(graph.nodes()), 0);
  for (Index n = 0; n < graph.nodes(); ++n) {
    result.prescribed[at(n)] = graph.members.row(n).front() >= 0 ? 1 : 0;
  }
  add_once(model.conditions.crack.pressure, of_vertex, at_vertex, result.prescribed,
           result.pressure);
  std::vector<std::uint8_t> taken = result.prescribed;
  add_once(model.conditions.crack.seepage_face, of_vertex, at_vertex, taken, result.seepage_face);
  add_crack_rates(model, graph, result);
  return result;
}

GraphConditions make_graph_conditions(const Model& model, const FlowGraph& graph) {
  const auto of_corner = [&](Index c) {
    return graph.node_of_corner[at(model.pore_nodes.leader(c))];
  };
  const auto of_vertex = [&](Index v) { return graph.node_of_vertex[at(v)]; };
  const auto at_corner = [&](Index c) { return model.mesh.vertex_of(c); };
  const auto at_vertex = [](Index v) { return v; };
  const Conditions& given = model.conditions;
  GraphConditions result;
  result.prescribed.assign(at(graph.nodes()), 0);
  add_once(given.pore.pressure, of_corner, at_corner, result.prescribed, result.pressure);
  add_once(given.crack.pressure, of_vertex, at_vertex, result.prescribed, result.pressure);
  std::vector<std::uint8_t> taken = result.prescribed;
  add_once(given.pore.seepage_face, of_corner, at_corner, taken, result.seepage_face);
  add_once(given.crack.seepage_face, of_vertex, at_vertex, taken, result.seepage_face);
  for (const NodeCondition& c : given.pore.rate) {
    result.rate.push_back({of_corner(c.place), at_corner(c.place), c});
  }
  add_crack_rates(model, graph, result);
  return result;
}

}  // namespace percolith::seepage
