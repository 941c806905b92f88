// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/solid_boundaries.hpp"

#include "percolith/simulation/groups.hpp"
#include "percolith/simulation/solid_build.hpp"

#include <algorithm>
#include <cmath>

namespace percolith::simulation {
namespace {

using mesh::Index;

Point displacement(const mechanics::Model& model, Index corner) {
  return {model.motion.ux[at(corner)], model.motion.uy[at(corner)]};
}

/// Tractions, pressure and in-situ stress over one edge, N/m.
Point load_on_edge(const Setup& setup, const BoundaryCondition& b, const mechanics::Model& model,
                   Index e) {
  const mesh::BoundaryEdge& edge = model.mesh.boundary[at(e)];
  const double t = model.motion.time;
  const Point first = model.mesh.vertex[at(edge.vertex[0])];
  const Point second = model.mesh.vertex[at(edge.vertex[1])];
  const Point along = second - first;
  const double length = std::sqrt(dot(along, along));
  Point force{length * b.traction_x.value_or(Schedule{}).at(t),
              length * b.traction_y.value_or(Schedule{}).at(t)};
  if (b.normal_pressure || b.pressurised) {
    const Point present =
        along + (displacement(model, edge.corner[1]) - displacement(model, edge.corner[0]));
    const Schedule pressure = b.pressurised ? b.pressure.value_or(Schedule{}) : *b.normal_pressure;
    force = force - pressure.at(t) * clockwise(present);
  }
  if (b.in_situ) {
    const InSitu stress = setup.in_situ.value_or(InSitu{});
    force = force + in_situ_stress(stress, 0.5 * (first + second)) * clockwise(along);
  }
  return force;
}

BoundaryState state_of(const Setup& setup, const std::string& name, const BoundaryCondition& b,
                       const mechanics::Model& model) {
  BoundaryState state{"boundary." + name, {}, {}};
  const std::vector<Index> edges = boundary_edges(model.mesh, b.groups, state.name + ".groups");
  for (const Index e : edges) {
    state.force = state.force + load_on_edge(setup, b, model, e);
    for (const Index corner : model.mesh.boundary[at(e)].corner) {
      state.displacement = state.displacement + displacement(model, corner);
    }
  }
  if (b.absorbing) {
    for (const mechanics::Dashpot& dashpot : mechanics::absorbing_edges(model, edges)) {
      const auto c = at(dashpot.corner);
      state.force =
          state.force - dashpot.resistance * Point{model.motion.vx[c], model.motion.vy[c]};
    }
  }
  const double corners = 2.0 * static_cast<double>(edges.size());
  state.displacement = corners > 0.0 ? (1.0 / corners) * state.displacement : Point{};
  return state;
}

}  // namespace

std::vector<BoundaryState> boundary_states(const Setup& setup,
                                           const mechanics::Dynamics& dynamics) {
  const mechanics::Model& model = dynamics.model();
  const mechanics::SupportSet& supports = dynamics.supports();
  const std::vector<Point> reaction = supports.reactions(model);
  const std::vector<Point> moved = supports.displacements(model);
  std::vector<BoundaryState> states;
  for (const auto& [name, boundary] : setup.boundary) {
    states.push_back(state_of(setup, name, boundary, model));
  }
  for (std::size_t i = 0; i < supports.tables().size(); ++i) {
    const std::string& table = supports.tables()[i];
    const auto found = std::find_if(states.begin(), states.end(),
                                    [&](const BoundaryState& s) { return s.name == table; });
    if (found == states.end()) {
      states.push_back({table, reaction[i], moved[i]});
    } else {
      found->force = found->force + reaction[i];
    }
  }
  return states;
}

}  // namespace percolith::simulation
