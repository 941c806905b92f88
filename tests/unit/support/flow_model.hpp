// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/seepage/model.hpp"
#include "percolith/seepage/set_state.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "unit/support/grid.hpp"
#include "unit/support/places.hpp"

// Flow models for tests, and their conditions by place.
namespace percolith::test {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

struct FlowOptions {
  material::Fluid fluid{};
  double gravity = 0.0;
  material::PoreRock rock{.permeability = {1e-13, 1e-13, 0.0}, .porosity = 0.2, .biot_modulus = {}};
  std::vector<material::Fracture> fracture{
      {.initial_aperture = 1e-4, .transmissivity = {}, .exchange = 1e-9}};
  seepage::PoreJoints joints = seepage::PoreJoints::tied;
  double joint_factor = 100.0;
  seepage::SaturationWeight weight = seepage::SaturationWeight::upstream;
};

inline seepage::Model make_flow(const mesh::GmshMesh& file, const FlowOptions& options) {
  mesh::Mesh mesh = mesh::build_mesh(file);
  std::vector<material::PoreRock> rock(mesh.region_names.size(), options.rock);
  return seepage::make_model(std::move(mesh), options.fluid, options.gravity, std::move(rock),
                             options.fracture, options.joints, options.joint_factor,
                             options.weight);
}

/// Breaks the joints of a named curve.
inline void break_curve(seepage::Model& model, const std::string& name, mesh::Index group = 0) {
  const std::vector<mesh::Index> joints = model.mesh.curves.at(name).joints;
  seepage::break_joints(model, joints, group);
}

/// Starts a condition and returns its number.
inline mesh::Index add_condition(seepage::Model& model, const std::string& name,
                                 const Schedule& schedule) {
  model.conditions.name.push_back(name);
  model.conditions.option.emplace_back("pressure");
  model.conditions.schedule.push_back(schedule);
  model.let_in.emplace_back();
  model.rate.push_back(0.0);
  return static_cast<mesh::Index>(model.let_in.size()) - 1;
}

/// Prescribes `factor(place) * schedule` at the pores of every vertex where `where(place)` holds.
template <class Where, class Factor>
void prescribe_pores(seepage::Model& model, const std::string& name, const Schedule& schedule,
                     const Where& where, const Factor& factor) {
  const auto number = add_condition(model, name, schedule);
  for (mesh::Index v = 0; v < model.mesh.vertices(); ++v) {
    const Point p = model.mesh.vertex[at(v)];
    if (where(p)) {
      for (const mesh::Index c : model.mesh.vertex_corners.row(v)) {
        model.conditions.pore.pressure.push_back({c, number, number, factor(p), 0.0});
      }
    }
  }
}

template <class Where>
void prescribe_pores(seepage::Model& model, const std::string& name, double pressure,
                     const Where& where) {
  prescribe_pores(model, name, Schedule::constant(pressure), where,
                  [](const Point&) { return 1.0; });
}

/// A seepage face at the pores of every vertex where `where(place)` holds.
template <class Where>
void face_pores(seepage::Model& model, const std::string& name, double outside,
                const Where& where) {
  const auto number = add_condition(model, name, Schedule::constant(outside));
  for (mesh::Index v = 0; v < model.mesh.vertices(); ++v) {
    if (where(model.mesh.vertex[at(v)])) {
      for (const mesh::Index c : model.mesh.vertex_corners.row(v)) {
        model.conditions.pore.seepage_face.push_back({c, number, number, 1.0, 0.0});
      }
    }
  }
}

inline void prescribe_crack(seepage::Model& model, const std::string& name,
                            const Schedule& schedule, Point place) {
  const auto number = add_condition(model, name, schedule);
  model.conditions.crack.pressure.push_back(
      {vertex_at(model.mesh, place), number, number, 1.0, 0.0});
}

inline void inject_pores(seepage::Model& model, const std::string& name, const Schedule& rate,
                         Point place) {
  const auto number = add_condition(model, name, rate);
  const mesh::Index corner = model.mesh.vertex_corners.row(vertex_at(model.mesh, place)).front();
  model.conditions.pore.rate.push_back({corner, number, number, 1.0, 0.0});
}

inline void inject_crack(seepage::Model& model, const std::string& name, const Schedule& rate,
                         Point place) {
  const auto number = add_condition(model, name, rate);
  model.conditions.crack.rate.push_back({vertex_at(model.mesh, place), number, number, 1.0, 0.0});
}

inline double pore_pressure(const seepage::Model& model, Point place) {
  const auto fan = model.mesh.vertex_corners.row(vertex_at(model.mesh, place));
  return model.state.pressure[at(fan.front())];
}

inline double crack_pressure(const seepage::Model& model, Point place) {
  return model.state.crack_pressure[at(vertex_at(model.mesh, place))];
}

/// Every corner slot that belongs to a triangle.
inline std::vector<mesh::Index> corners_of(const mesh::Mesh& mesh) {
  std::vector<mesh::Index> corners;
  for (mesh::Index t = 0; t < mesh.triangles(); ++t) {
    for (mesh::Index k = 0; k < 3; ++k) {
      corners.push_back(mesh::corner_of(t, k));
    }
  }
  return corners;
}

/// Fluid that came without passing a condition, over fluid in place and throughput.
class Balance {
public:
  explicit Balance(const seepage::Model& model)
      : start_(seepage::fluid_in_place(model, Execution())), let_in_(total(model)) {}
  [[nodiscard]] double error(const seepage::Model& model) const {
    const double in_place = seepage::fluid_in_place(model, Execution());
    double throughput = 0.0;
    for (const auto& volume : model.let_in) {
      throughput += std::abs(volume.total());
    }
    return std::abs(in_place - start_ - (total(model) - let_in_)) / (in_place + throughput);
  }

private:
  static double total(const seepage::Model& model) {
    double sum = 0.0;
    for (const auto& volume : model.let_in) {
      sum += volume.total();
    }
    return sum;
  }
  double start_;
  double let_in_;
};

/// Smallest and largest saturation of pores and open crack nodes.
inline std::pair<double, double> saturation_range(const seepage::Model& model) {
  std::pair<double, double> range{infinity, -infinity};
  const auto add = [&](double s) { range = {std::min(range.first, s), std::max(range.second, s)}; };
  for (const mesh::Index c : corners_of(model.mesh)) {
    add(model.state.saturation[at(c)]);
  }
  for (const mesh::Index v : model.cracks.open_nodes()) {
    add(model.state.crack_saturation[at(v)]);
  }
  return range;
}

}  // namespace percolith::test
