// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/crack.hpp"
#include "percolith/seepage/model.hpp"

#include <algorithm>

namespace percolith::seepage {
namespace {

void set_crack_properties(Model& model, Index joint, Index group) {
  const material::Fracture& fracture = model.fracture[at(group)];
  const double length = model.mesh.joint_length(joint);
  const double aperture = hydraulic_aperture(fracture, 0.0);
  model.crack.group[at(joint)] = group;
  model.crack.aperture[at(joint)] = aperture;
  model.crack.conductance[at(joint)] =
      crack_conductance(fracture, aperture, length, model.fluid.viscosity);
  model.crack.exchange[at(joint)] = exchange_conductance(fracture, length);
}

/// Half the volume of every broken joint at the vertex, summed in ascending order (theory.md
/// section 5).
double crack_volume(const Model& model, Index vertex) {
  double volume = 0.0;
  for (const Index j : model.mesh.vertex_joints.row(vertex)) {
    if (model.cracks.is_broken(j)) {
      const material::Fracture& fracture = model.fracture[at(model.crack.group[at(j)])];
      volume += 0.5 * storage_aperture(fracture, 0.0) * model.mesh.joint_length(j);
    }
  }
  return volume;
}

/// New crack volume joins empty: the fluid stays, its excess over a full node falls.
void grow_crack_node(Model& model, Index vertex) {
  const auto i = at(vertex);
  const double before = model.crack.void_volume[i];
  model.crack.void_volume[i] = crack_volume(model, vertex);
  CompensatedSum content{model.state.crack_content[i], model.state.crack_content_carry[i]};
  content += before - model.crack.void_volume[i];
  set_crack_content(model, vertex, content);
}

/// Each part of a split node keeps the pressure or saturation its corners have.
void split_pore_node(Model& model, Index vertex) {
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
    model.pore_nodes.for_each_corner(model.mesh, node, [&](Index corner) {
      s.storage[i] += model.pore.storage[at(corner)];
      s.void_volume[i] += model.pore.void_volume[at(corner)];
    });
    s.content[i] = excess_of({s.pressure[i], s.saturation[i]}, 0.0, s.storage[i], s.void_volume[i],
                             model.reference_pressure());
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
    grow_crack_node(model, v);
    split_pore_node(model, v);
  }
}

}  // namespace percolith::seepage
