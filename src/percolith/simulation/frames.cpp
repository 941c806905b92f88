// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/frames.hpp"

#include "percolith/seepage/pore.hpp"
#include "percolith/seepage/pore_flow.hpp"

namespace percolith::simulation {
std::array<double, 3> triangle_flows(const seepage::Model& model, Index triangle) {
  const seepage::State& s = model.state;
  std::array<double, 3> flow{};
  std::array<double, 3> weight{};
  double mean = 0.0;
  for (Index k = 0; k < 3; ++k) {
    mean += s.saturation[at(mesh::corner_of(triangle, k))] / 3.0;
  }
  for (Index k = 0; k < 3; ++k) {
    weight[at(k)] =
        seepage::saturation_weight(model.weight == seepage::SaturationWeight::mean
                                       ? mean
                                       : s.saturation[at(mesh::corner_of(triangle, k))]);
  }
  for (Index k = 0; k < 3; ++k) {
    const auto a = at(mesh::corner_of(triangle, k));
    const auto b = at(mesh::corner_of(triangle, (k + 1) % 3));
    const double difference =
        (s.pressure[b] - s.pressure[a]) + (model.pore.lift[b] - model.pore.lift[a]);
    flow[at(k)] = -seepage::pair_flow(model.pore.conductance[a], difference, weight[at(k)],
                                      weight[at((k + 1) % 3)]);
  }
  return flow;
}

double crack_flow(const seepage::Model& model, Index joint) {
  const auto& ends = model.mesh.joint[at(joint)].vertex;
  const auto a = at(ends[0]);
  const auto b = at(ends[1]);
  const seepage::State& s = model.state;
  const double difference =
      (s.crack_pressure[a] - s.crack_pressure[b]) + (model.crack.lift[a] - model.crack.lift[b]);
  return seepage::pair_flow(model.crack.conductance[at(joint)], difference,
                            seepage::saturation_weight(s.crack_saturation[b]),
                            seepage::saturation_weight(s.crack_saturation[a]));
}

MatrixFrame matrix_frame(const seepage::Model& model, double head_datum) {
  const mesh::Mesh& mesh = model.mesh;
  const double weight = model.fluid.density * model.gravity;
  MatrixFrame frame;
  std::vector<Index> number(at(mesh.corners()), mesh::none);
  for (const Index node : model.pore_nodes.nodes(mesh)) {
    number[at(node)] = static_cast<Index>(frame.points.size());
    frame.points.push_back(mesh.place_of(node));
    frame.pressure.push_back(model.state.pressure[at(node)]);
    frame.saturation.push_back(model.state.saturation[at(node)]);
    if (weight > 0.0) {
      frame.head.push_back(frame.pressure.back() / weight + (frame.points.back().y - head_datum));
    }
  }
  frame.region = mesh.region;
  frame.triangles.reserve(at(mesh.triangles()));
  frame.flux.reserve(at(mesh.triangles()));
  for (Index t = 0; t < mesh.triangles(); ++t) {
    std::array<Index, 3> corners{};
    for (Index k = 0; k < 3; ++k) {
      corners[at(k)] = number[at(model.pore_nodes.leader(mesh::corner_of(t, k)))];
    }
    frame.triangles.push_back(corners);
    frame.flux.push_back(seepage::darcy_flux(mesh.triangle_points(t), triangle_flows(model, t)));
  }
  return frame;
}

CrackFrame crack_frame(const seepage::Model& model, double head_datum) {
  const mesh::Mesh& mesh = model.mesh;
  const double weight = model.fluid.density * model.gravity;
  CrackFrame frame;
  std::vector<Index> number(at(mesh.vertices()), mesh::none);
  for (const Index v : model.cracks.open_nodes()) {
    number[at(v)] = static_cast<Index>(frame.points.size());
    frame.points.push_back(mesh.vertex[at(v)]);
    frame.pressure.push_back(model.state.crack_pressure[at(v)]);
    frame.saturation.push_back(model.state.crack_saturation[at(v)]);
    if (weight > 0.0) {
      frame.head.push_back(frame.pressure.back() / weight + (frame.points.back().y - head_datum));
    }
  }
  for (const Index j : model.cracks.broken_joints()) {
    const auto& ends = mesh.joint[at(j)].vertex;
    frame.segments.push_back({number[at(ends[0])], number[at(ends[1])]});
    frame.group.push_back(model.crack.group[at(j)]);
    frame.aperture.push_back(model.crack.aperture[at(j)]);
    frame.flux.push_back(crack_flow(model, j));
  }
  return frame;
}

}  // namespace percolith::simulation
