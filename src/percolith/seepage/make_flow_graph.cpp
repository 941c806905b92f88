// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/disjoint_sets.hpp"
#include "percolith/seepage/flow_graph.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace percolith::seepage {
namespace {

bool shares_pressure(const Model& model, Index joint) {
  return model.cracks.is_broken(joint) && std::isinf(model.crack.exchange[at(joint)]);
}

/// Merges crack nodes with the pore nodes they face through infinite exchange.
class Groups {
public:
  explicit Groups(const Model& model)
      : corners_(model.mesh.corners()), sets_(corners_ + model.mesh.vertices()) {
    for (const Index j : model.cracks.broken_joints()) {
      if (!shares_pressure(model, j)) {
        continue;
      }
      const mesh::Joint& joint = model.mesh.joint[at(j)];
      for (std::size_t end = 0; end < 2; ++end) {
        for (std::size_t side = 0; side < 2; ++side) {
          sets_.merge(model.pore_nodes.leader(joint.corner[side][end]),
                      corners_ + joint.vertex[end]);
        }
      }
    }
  }
  Index root_of_corner(Index leader) { return sets_.root(leader); }
  Index root_of_vertex(Index vertex) { return sets_.root(corners_ + vertex); }

private:
  Index corners_;
  DisjointSets sets_;
};

/// Numbers the nodes along the mesh, so that neighbours in space are neighbours in memory.
void number_nodes(const Model& model, FlowGraph& graph) {
  Groups groups(model);
  const mesh::Mesh& mesh = model.mesh;
  std::vector<Index> number(at(mesh.corners() + mesh.vertices()), mesh::none);
  Index count = 0;
  const auto assign = [&](Index root) {
    if (number[at(root)] == mesh::none) {
      number[at(root)] = count++;
    }
    return number[at(root)];
  };
  graph.node_of_corner.assign(at(mesh.corners()), mesh::none);
  graph.node_of_vertex.assign(at(mesh.vertices()), mesh::none);
  std::vector<std::pair<Index, Index>> member;  // node, corner or crack vertex
  member.reserve(at(mesh.vertices()));
  for (Index v = 0; v < mesh.vertices(); ++v) {
    for (const Index c : mesh.vertex_corners.row(v)) {
      if (model.pore_nodes.leader(c) == c) {
        graph.node_of_corner[at(c)] = assign(groups.root_of_corner(c));
        member.emplace_back(graph.node_of_corner[at(c)], c);
      }
    }
    if (model.cracks.is_open(v)) {
      graph.node_of_vertex[at(v)] = assign(groups.root_of_vertex(v));
      member.emplace_back(graph.node_of_vertex[at(v)], -1 - v);
    }
  }
  // Only shared pressures disturb the order in which the nodes were met.
  if (!std::is_sorted(member.begin(), member.end())) {
    std::sort(member.begin(), member.end());
  }
  graph.members.start.assign(at(count) + 1, 0);
  graph.members.entry.reserve(member.size());
  for (const auto& [node, item] : member) {
    ++graph.members.start[at(node) + 1];
    graph.members.entry.push_back(item);
  }
  std::partial_sum(graph.members.start.begin(), graph.members.start.end(),
                   graph.members.start.begin());
}

void set_volumes(const Model& model, FlowGraph& graph) {
  const auto nodes = graph.members.start.size() - 1;
  graph.storage.assign(nodes, 0.0);
  graph.void_volume.assign(nodes, 0.0);
  graph.lift.resize(nodes);
  for (std::size_t n = 0; n < nodes; ++n) {
    for (const Index m : graph.members.row(static_cast<Index>(n))) {
      const Index vertex = m < 0 ? -1 - m : model.mesh.vertex_of(m);
      graph.storage[n] += m < 0 ? model.crack_storage(vertex) : model.state.storage[at(m)];
      graph.void_volume[n] += m < 0 ? model.crack.void_volume[at(vertex)]
                                    : model.state.void_volume[at(m)] + model.state.growth[at(m)];
      graph.lift[n] = model.crack.lift[at(vertex)];
    }
  }
}

/// Numbers crack nodes and the pore nodes they face.
void number_crack_nodes(const Model& model, FlowGraph& graph) {
  graph.node_of_corner.assign(at(model.mesh.corners()), mesh::none);
  graph.node_of_vertex.assign(model.mesh.vertex.size(), mesh::none);
  auto& members = graph.members.entry;
  for (const Index v : model.cracks.open_nodes()) {
    graph.node_of_vertex[at(v)] = static_cast<Index>(members.size());
    members.push_back(-1 - v);
  }
  for (const Index j : model.cracks.broken_joints()) {
    for (const auto& side : model.mesh.joint[at(j)].corner) {
      for (const Index corner : side) {
        const Index face = model.pore_nodes.leader(corner);
        if (model.crack.exchange[at(j)] > 0.0 && graph.node_of_corner[at(face)] == mesh::none) {
          graph.node_of_corner[at(face)] = static_cast<Index>(members.size());
          members.push_back(face);
        }
      }
    }
  }
  graph.members.start.resize(members.size() + 1);
  std::iota(graph.members.start.begin(), graph.members.start.end(), 0);
}

void add_edge(FlowGraph& graph, Index from, Index to, double conductance) {
  graph.from.push_back(from);
  graph.to.push_back(to);
  graph.conductance.push_back(conductance);
}

void add_triangles(const Model& model, FlowGraph& graph) {
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    for (Index k = 0; k < 3; ++k) {
      const Index corner = mesh::corner_of(t, k);
      const Index next = mesh::corner_of(t, (k + 1) % 3);
      add_edge(graph, graph.node_of_corner[at(model.pore_nodes.leader(corner))],
               graph.node_of_corner[at(model.pore_nodes.leader(next))],
               model.pore.conductance[at(corner)]);
    }
  }
  graph.triangle_edges = graph.edges();
}

void add_finite_joints(const Model& model, FlowGraph& graph) {
  for (Index j = 0; j < static_cast<Index>(model.pore.joint.size()); ++j) {
    if (model.cracks.is_broken(j)) {
      continue;
    }
    const auto& corner = model.mesh.joint[at(j)].corner;
    for (std::size_t end = 0; end < 2; ++end) {
      const Index first = graph.node_of_corner[at(corner[0][end])];
      const Index second = graph.node_of_corner[at(corner[1][end])];
      // Next to a fracture with infinite exchange both corners may share its pressure.
      if (first != second) {
        add_edge(graph, first, second, model.pore.joint[at(j)]);
      }
    }
  }
  graph.joint_edges = graph.edges();
}

void add_cracks(const Model& model, FlowGraph& graph) {
  for (const Index j : model.cracks.broken_joints()) {
    const mesh::Joint& joint = model.mesh.joint[at(j)];
    add_edge(graph, graph.node_of_vertex[at(joint.vertex[0])],
             graph.node_of_vertex[at(joint.vertex[1])], model.crack.conductance[at(j)]);
  }
  graph.crack_edges = graph.edges();
}

void add_exchange(const Model& model, FlowGraph& graph) {
  for (const Index j : model.cracks.broken_joints()) {
    if (shares_pressure(model, j) || model.crack.exchange[at(j)] == 0.0) {
      continue;
    }
    const mesh::Joint& joint = model.mesh.joint[at(j)];
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t end = 0; end < 2; ++end) {
        const Index face = model.pore_nodes.leader(joint.corner[side][end]);
        const Index crack_node = graph.node_of_vertex[at(joint.vertex[end])];
        // A crossing fracture may already have given both the same pressure.
        if (graph.node_of_corner[at(face)] != crack_node) {
          add_edge(graph, graph.node_of_corner[at(face)], crack_node, model.crack.exchange[at(j)]);
        }
      }
    }
  }
}

void set_incidence(FlowGraph& graph) {
  const auto nodes = graph.storage.size();
  graph.incidence.start.assign(nodes + 1, 0);
  for (Index e = 0; e < graph.edges(); ++e) {
    ++graph.incidence.start[at(graph.from[at(e)]) + 1];
    ++graph.incidence.start[at(graph.to[at(e)]) + 1];
  }
  std::partial_sum(graph.incidence.start.begin(), graph.incidence.start.end(),
                   graph.incidence.start.begin());
  graph.incidence.entry.resize(2 * graph.from.size());
  std::vector<Index> next(graph.incidence.start.begin(), graph.incidence.start.end() - 1);
  for (Index e = 0; e < graph.edges(); ++e) {
    graph.incidence.entry[at(next[at(graph.from[at(e)])]++)] = 2 * e;
    graph.incidence.entry[at(next[at(graph.to[at(e)])]++)] = 2 * e + 1;
  }
}

}  // namespace

FlowGraph make_flow_graph(const Model& model) {
  FlowGraph graph;
  number_nodes(model, graph);
  set_volumes(model, graph);
  const std::size_t expected = 3 * at(model.mesh.triangles()) + 2 * model.pore.joint.size() +
                               5 * model.cracks.broken_joints().size();
  graph.from.reserve(expected);
  graph.to.reserve(expected);
  graph.conductance.reserve(expected);
  add_triangles(model, graph);
  add_finite_joints(model, graph);
  add_cracks(model, graph);
  add_exchange(model, graph);
  set_incidence(graph);
  return graph;
}

FlowGraph make_crack_graph(const Model& model) {
  FlowGraph graph;
  number_crack_nodes(model, graph);
  set_volumes(model, graph);
  add_cracks(model, graph);
  add_exchange(model, graph);
  set_incidence(graph);
  return graph;
}

void refresh_graph(const Model& model, FlowGraph& graph) {
  set_volumes(model, graph);
  auto edge = at(graph.joint_edges);
  for (const Index j : model.cracks.broken_joints()) {
    graph.conductance[edge++] = model.crack.conductance[at(j)];
  }
}

Point FlowGraph::place(const Model& model, Index node) const {
  const Index m = members.row(node).front();
  return m < 0 ? model.mesh.vertex[at(-1 - m)] : model.mesh.place_of(m);
}

const char* FlowGraph::kind(Index node) const {
  return members.row(node).back() < 0 ? "crack node" : "pore node";
}

}  // namespace percolith::seepage
