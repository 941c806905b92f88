// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/crack.hpp"
#include "percolith/seepage/model.hpp"

#include <algorithm>

namespace percolith::seepage {
namespace {

void set_conductance(Model& model, Index joint) {
  CrackProperties& crack = model.crack;
  const auto j = at(joint);
  const material::Fracture& fracture = model.fracture[at(crack.group[j])];
  crack.aperture[j] = hydraulic_aperture(
      fracture, 0.5 * (crack.opening[0][j] + crack.opening[1][j]), crack.compression[j]);
  crack.conductance[j] = crack_conductance(fracture, crack.aperture[j],
                                           model.mesh.joint_length(joint), model.fluid.viscosity);
}

void set_crack_properties(Model& model, Index joint, Index group) {
  const material::Fracture& fracture = model.fracture[at(group)];
  const double length = model.mesh.joint_length(joint);
  model.crack.group[at(joint)] = group;
  set_conductance(model, joint);
  model.crack.exchange[at(joint)] = exchange_conductance(fracture, length);
}

/// Half the volume of every broken joint at the vertex, by the opening at that end, summed in
/// ascending order (theory.md section 5).
double crack_volume(const Model& model, Index vertex) {
  double volume = 0.0;
  for (const Index j : model.mesh.vertex_joints.row(vertex)) {
    if (model.cracks.is_broken(j)) {
      const material::Fracture& fracture = model.fracture[at(model.crack.group[at(j)])];
      const auto end = at(model.mesh.joint_end(j, vertex));
      volume += 0.5 *
                storage_aperture(fracture, model.crack.opening[end][at(j)],
                                 model.crack.compression[at(j)]) *
                model.mesh.joint_length(j);
    }
  }
  return volume;
}

/// New crack volume joins empty: the fluid stays, its excess over a full node falls by as much as
/// the volume grows. The difference of two volumes that are close is exact.
void resize_crack_node(Model& model, Index vertex) {
  const auto i = at(vertex);
  const double before = model.crack.void_volume[i];
  model.crack.void_volume[i] = crack_volume(model, vertex);
  CompensatedSum content{model.state.crack_content[i], model.state.crack_content_carry[i]};
  content += before - model.crack.void_volume[i];
  set_crack_content(model, vertex, content);
}

/// Each part of a split node keeps the pressure or saturation its corners have.
void split_pore_node(Model& model, Index vertex) {
  if (!model.swelling.empty()) {
    take_swelling(model, vertex);
  }
  if (!model.pore_nodes.refresh(model.mesh, model.tied, vertex)) {
    return;
  }
  State& s = model.state;
  for (const Index node : model.mesh.vertex_corners.row(vertex)) {
    if (model.pore_nodes.leader(node) != node) {
      continue;
    }
    const auto i = at(node);
    s.storage[i] = 0.0;
    s.void_volume[i] = 0.0;
    double growth = 0.0;
    model.pore_nodes.for_each_corner(model.mesh, node, [&](Index corner) {
      s.storage[i] += model.pore.storage[at(corner)];
      s.void_volume[i] += model.pore.void_volume[at(corner)];
      growth += model.swelling.empty() ? 0.0 : model.swelling[at(mesh::triangle_of(corner))];
    });
    s.growth[i] = (1.0 / 3.0) * growth;
    s.content[i] = excess_of({s.pressure[i], s.saturation[i]}, s.growth[i], s.storage[i],
                             s.void_volume[i], model.reference_pressure());
    s.content_carry[i] = 0.0;
  }
}

}  // namespace

void break_joints(Model& model, std::span<const Index> joints, Index group) {
  std::vector<Index> vertices;
  for (const Index j : model.cracks.break_joints(model.mesh, joints)) {
    set_crack_properties(model, j, group);
    model.tied[at(j)] = 0;
    const auto& ends = model.mesh.joint[at(j)].vertex;
    vertices.insert(vertices.end(), ends.begin(), ends.end());
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for (const Index v : vertices) {
    resize_crack_node(model, v);
    split_pore_node(model, v);
  }
}

void open_cracks(Model& model, std::span<const CrackOpening> openings) {
  for (const CrackOpening& crack : openings) {
    for (std::size_t end = 0; end < 2; ++end) {
      model.crack.opening[end][at(crack.joint)] = crack.opening[end];
    }
    model.crack.compression[at(crack.joint)] = crack.compression;
    set_conductance(model, crack.joint);
  }
  for (const Index v : model.cracks.open_nodes()) {
    resize_crack_node(model, v);
  }
}

}  // namespace percolith::seepage
