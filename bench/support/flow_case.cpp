// SPDX-License-Identifier: BSD-3-Clause
#include "bench/support/flow_case.hpp"

#include "percolith/seepage/set_state.hpp"

#include "bench/support/grid_mesh.hpp"

namespace percolith::bench {
namespace {

constexpr double left = 2e6;   // Pa
constexpr double right = 1e6;  // Pa

void prescribe(seepage::Model& model, const std::string& curve, double pressure) {
  const auto number = static_cast<mesh::Index>(model.conditions.schedule.size());
  model.conditions.schedule.push_back(Schedule::constant(pressure));
  model.conditions.name.push_back("boundary." + curve);
  model.let_in.emplace_back();
  model.rate.push_back(0.0);
  std::vector<std::uint8_t> taken(static_cast<std::size_t>(model.mesh.corners()), 0);
  for (const mesh::Index edge : model.mesh.curves.at(curve).boundary) {
    for (const mesh::Index corner : model.mesh.boundary[static_cast<std::size_t>(edge)].corner) {
      const mesh::Index node = model.pore_nodes.leader(corner);
      if (taken[static_cast<std::size_t>(node)]++ == 0) {
        model.conditions.pore.pressure.push_back({node, number, number, 1.0, 0.0});
      }
    }
  }
}

}  // namespace

mesh::Mesh make_flow_mesh(std::int32_t triangles) {
  return mesh::build_mesh(grid_mesh(cells_for(triangles)));
}

seepage::Model make_flow_model(const mesh::Mesh& mesh, const FlowCase& flow) {
  material::PoreRock rock;
  rock.permeability = {2e-13, 1e-13, 3e-14};
  material::Fracture fracture;
  fracture.initial_aperture = flow.aperture;
  fracture.exchange = flow.exchange;
  seepage::Model model =
      seepage::make_model(mesh, material::Fluid{}, flow.gravity, {rock}, {fracture}, flow.joints,
                          10.0, seepage::SaturationWeight::upstream);
  if (flow.fractured) {
    seepage::break_joints(model, model.mesh.curves.at("fractures").joints, 0);
  }
  const seepage::FluidState<double> start{flow.partly_empty ? 0.0 : right,
                                          flow.partly_empty ? 0.5 : 1.0};
  seepage::set_pores(model, [&](const Point&) { return start; });
  seepage::set_cracks(model, [&](const Point&) { return start; });
  prescribe(model, "left", left);
  prescribe(model, "right", right);
  return model;
}

}  // namespace percolith::bench
