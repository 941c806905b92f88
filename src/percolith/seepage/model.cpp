// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/model.hpp"

#include "percolith/seepage/pore.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace percolith::seepage {
namespace {

/// Edge of the equilateral triangle with the area of triangle `t`: its element size, m.
double element_size(const mesh::Mesh& mesh, Index t) {
  return 2.0 * std::sqrt(mesh.area(t) / std::sqrt(3.0));
}

/// Permeability across a joint in the triangle on one side, n.k n, m2.
double normal_permeability(const Model& model, Index joint, Index triangle) {
  const auto& ends = model.mesh.joint[at(joint)].vertex;
  const Point along = model.mesh.vertex[at(ends[1])] - model.mesh.vertex[at(ends[0])];
  const Point normal = clockwise(along);
  const Tensor& k = model.rock[at(model.mesh.region[at(triangle)])].permeability;
  return dot(normal, k * normal) / dot(normal, normal);
}

/// 1/2 h_j L of every joint, (20).
std::vector<double> finite_joints(const Model& model, double joint_factor) {
  std::vector<double> half(model.mesh.joint.size());
  for (Index j = 0; j < model.mesh.joints(); ++j) {
    const auto& corner = model.mesh.joint[at(j)].corner;
    const Index first = mesh::triangle_of(corner[0][0]);
    const Index second = mesh::triangle_of(corner[1][0]);
    const double h =
        joint_exchange(joint_factor, normal_permeability(model, j, first),
                       element_size(model.mesh, first), normal_permeability(model, j, second),
                       element_size(model.mesh, second), model.fluid.viscosity);
    half[at(j)] = 0.5 * h * model.mesh.joint_length(j);
  }
  return half;
}

PoreProperties pore_properties(const Model& model) {
  const auto slots = at(model.mesh.corners());
  PoreProperties pore;
  pore.conductance.assign(slots, 0.0);
  pore.lift.assign(slots, 0.0);
  pore.storage.assign(slots, 0.0);
  pore.void_volume.assign(slots, 0.0);
  const double weight = model.fluid.density * model.gravity;
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    const Index region = model.mesh.region[at(t)];
    const material::PoreRock& rock = model.rock[at(region)];
    const auto points = model.mesh.triangle_points(t);
    const auto conductance = pair_conductances(points, rock.permeability, model.fluid.viscosity);
    const double volume = model.mesh.area(t) / 3.0;
    for (Index k = 0; k < 3; ++k) {
      const auto slot = at(mesh::corner_of(t, k));
      pore.conductance[slot] = conductance[at(k)];
      pore.lift[slot] = weight * points[at(k)].y;
      pore.storage[slot] = volume / model.biot_modulus(region);
      pore.void_volume[slot] = volume * rock.porosity;
    }
  }
  return pore;
}

CrackProperties crack_properties(const Model& model) {
  CrackProperties crack;
  crack.group.assign(model.mesh.joint.size(), mesh::none);
  for (auto& opening : crack.opening) {
    opening.assign(model.mesh.joint.size(), 0.0);
  }
  crack.compression.assign(model.mesh.joint.size(), 0.0);
  crack.aperture.assign(model.mesh.joint.size(), 0.0);
  crack.conductance.assign(model.mesh.joint.size(), 0.0);
  crack.exchange.assign(model.mesh.joint.size(), 0.0);
  crack.void_volume.assign(model.mesh.vertex.size(), 0.0);
  crack.lift.resize(model.mesh.vertex.size());
  for (std::size_t v = 0; v < crack.lift.size(); ++v) {
    crack.lift[v] = model.fluid.density * model.gravity * model.mesh.vertex[v].y;
  }
  return crack;
}

State empty_state(const Model& model) {
  const auto slots = at(model.mesh.corners());
  const auto vertices = at(model.mesh.vertices());
  State state;
  state.pressure.assign(slots, model.reference_pressure());
  state.saturation.assign(slots, 1.0);
  state.content.assign(slots, 0.0);
  state.content_carry.assign(slots, 0.0);
  state.storage.assign(slots, 0.0);
  state.void_volume.assign(slots, 0.0);
  state.growth.assign(slots, 0.0);
  for (Index c = 0; c < model.mesh.corners(); ++c) {
    const auto node = at(model.pore_nodes.leader(c));
    state.storage[node] += model.pore.storage[at(c)];
    state.void_volume[node] += model.pore.void_volume[at(c)];
  }
  state.crack_pressure.assign(vertices, model.reference_pressure());
  state.crack_saturation.assign(vertices, 1.0);
  state.crack_content.assign(vertices, 0.0);
  state.crack_content_carry.assign(vertices, 0.0);
  return state;
}

}  // namespace

double Model::biot_modulus(Index region) const {
  const material::PoreRock& r = rock[at(region)];
  return r.biot_modulus.value_or(fluid.bulk_modulus / r.porosity);
}

Model make_model(mesh::Mesh mesh, const material::Fluid& fluid, double gravity,
                 std::vector<material::PoreRock> rock, std::vector<material::Fracture> fracture,
                 PoreJoints joints, double joint_factor, SaturationWeight weight) {
  std::vector<std::uint8_t> tied(mesh.joint.size(), joints == PoreJoints::tied ? 1 : 0);
  mesh::CrackNetwork cracks(mesh);
  mesh::NodeMap nodes(mesh, tied);
  Model model{.mesh = std::move(mesh),
              .fluid = fluid,
              .gravity = gravity,
              .pore_joints = joints,
              .weight = weight,
              .rock = std::move(rock),
              .fracture = std::move(fracture),
              .cracks = std::move(cracks),
              .tied = std::move(tied),
              .pore_nodes = std::move(nodes),
              .pore = {},
              .crack = {},
              .conditions = {},
              .state = {},
              .let_in = {},
              .rate = {},
              .passed_in = {},
              .passed_out = {}};
  model.pore = pore_properties(model);
  if (joints == PoreJoints::finite) {
    model.pore.joint = finite_joints(model, joint_factor);
  }
  model.crack = crack_properties(model);
  model.state = empty_state(model);
  return model;
}

void set_pore_content(Model& model, Index node, CompensatedSum content) {
  State& s = model.state;
  const auto i = at(node);
  s.content[i] = content.value;
  s.content_carry[i] = content.carry;
  const auto fluid = fluid_state(content.total(), s.growth[i], s.storage[i], s.void_volume[i],
                                 model.reference_pressure(), model.can_empty());
  model.pore_nodes.for_each_corner(model.mesh, node, [&](Index corner) {
    s.pressure[at(corner)] = fluid.pressure;
    s.saturation[at(corner)] = fluid.saturation;
  });
}

void set_crack_content(Model& model, Index vertex, CompensatedSum content) {
  State& s = model.state;
  const auto i = at(vertex);
  s.crack_content[i] = content.value;
  s.crack_content_carry[i] = content.carry;
  const auto fluid =
      fluid_state(content.total(), 0.0, model.crack_storage(vertex), model.crack.void_volume[i],
                  model.reference_pressure(), model.can_empty());
  s.crack_pressure[i] = fluid.pressure;
  s.crack_saturation[i] = fluid.saturation;
}

namespace {

double growth_of(const Model& model, Index node) {
  double growth = 0.0;
  model.pore_nodes.for_each_corner(model.mesh, node, [&](Index corner) {
    growth += model.swelling[at(mesh::triangle_of(corner))];
  });
  return (1.0 / 3.0) * growth;
}

}  // namespace

void take_growth(Model& model) {
  for (Index c = 0; c < model.mesh.corners(); ++c) {
    if (model.pore_nodes.leader(c) == c && mesh::triangle_of(c) < model.mesh.triangles()) {
      model.state.growth[at(c)] = growth_of(model, c);
    }
  }
}

void take_swelling(Model& model, Index vertex) {
  State& s = model.state;
  for (const Index node : model.mesh.vertex_corners.row(vertex)) {
    if (model.pore_nodes.leader(node) == node) {
      s.growth[at(node)] = growth_of(model, node);
      set_pore_content(model, node, {s.content[at(node)], s.content_carry[at(node)]});
    }
  }
}

double fluid_in_place(const Model& model, const Execution& execution) {
  const State& s = model.state;
  const double pores = execution.sum(model.mesh.corners(), [&](Index c) {
    const auto i = at(c);
    return model.pore_nodes.leader(c) == c ? s.void_volume[i] + (s.content[i] + s.content_carry[i])
                                           : 0.0;
  });
  const double cracks = execution.sum(model.mesh.vertices(), [&](Index v) {
    const auto i = at(v);
    return model.crack.void_volume[i] + (s.crack_content[i] + s.crack_content_carry[i]);
  });
  return pores + cracks;
}

}  // namespace percolith::seepage
