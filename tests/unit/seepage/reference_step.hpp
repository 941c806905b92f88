// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <numeric>
#include <vector>

#include "unit/support/flow_model.hpp"

// One explicit step written down plainly from the equations, with its own nodes, conductances and
// state equation, to be compared with the kernels.
namespace percolith::seepage::reference {

using test::at;

inline double weight_of(double s) {
  return 3.0 * s * s - 2.0 * s * s * s;
}

struct Result {
  std::vector<double> pressure, saturation;              // per corner
  std::vector<double> crack_pressure, crack_saturation;  // per vertex
};

class Step {
public:
  Step(const Model& model, const test::FlowOptions& options)
      : model_(model), options_(options), inflow_(at(model.mesh.corners()), 0.0),
        crack_inflow_(model.mesh.vertex.size(), 0.0) {}

  [[nodiscard]] Result advance(double dt) {
    triangles();
    joints();
    return contents(dt);
  }

private:
  [[nodiscard]] double potential(Index c) const {
    return model_.state.pressure[at(c)] +
           options_.fluid.density * options_.gravity * model_.mesh.place_of(c).y;
  }

  void triangles() {
    for (Index t = 0; t < model_.mesh.triangles(); ++t) {
      const auto p = model_.mesh.triangle_points(t);
      const double twice_area = cross(p[1] - p[0], p[2] - p[0]);
      std::array<Point, 3> gradient;
      double mean = 0.0;
      for (std::size_t i = 0; i < 3; ++i) {
        const Point edge = p[(i + 2) % 3] - p[(i + 1) % 3];
        gradient[i] = {-edge.y / twice_area, edge.x / twice_area};
        mean += model_.state.saturation[at(mesh::corner_of(t, static_cast<Index>(i)))] / 3.0;
      }
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i + 1; j < 3; ++j) {
          const Index a = mesh::corner_of(t, static_cast<Index>(i));
          const Index b = mesh::corner_of(t, static_cast<Index>(j));
          const Tensor& k = options_.rock.permeability;
          double flow = -0.5 * twice_area / options_.fluid.viscosity *
                        dot(gradient[i], k * gradient[j]) * (potential(b) - potential(a));
          const Index donor = flow > 0.0 ? b : a;
          flow *= weight_of(options_.weight == SaturationWeight::mean
                                ? mean
                                : model_.state.saturation[at(donor)]);
          inflow_[at(a)] += flow;
          inflow_[at(b)] -= flow;
        }
      }
    }
  }

  void joints() {
    for (Index j = 0; j < model_.mesh.joints(); ++j) {
      if (model_.cracks.is_broken(j)) {
        crack(j);
      } else if (options_.joints == PoreJoints::finite) {
        finite(j);
      }
    }
  }

  void finite(Index j) {
    const auto& joint = model_.mesh.joint[at(j)];
    const double length = model_.mesh.joint_length(j);
    double resistance = 0.0;  // of both halves, per length
    const Point along =
        model_.mesh.vertex[at(joint.vertex[1])] - model_.mesh.vertex[at(joint.vertex[0])];
    const Point normal{along.y / length, -along.x / length};
    for (std::size_t side = 0; side < 2; ++side) {
      const double area = model_.mesh.area(mesh::triangle_of(joint.corner[side][0]));
      const double size = std::sqrt(4.0 * area / std::sqrt(3.0));
      const double k = dot(normal, options_.rock.permeability * normal);
      resistance += 0.5 * options_.fluid.viscosity * size / (options_.joint_factor * k);
    }
    for (std::size_t end = 0; end < 2; ++end) {
      const Index a = joint.corner[0][end];
      const Index b = joint.corner[1][end];
      double flow =
          0.5 * length / resistance * (model_.state.pressure[at(b)] - model_.state.pressure[at(a)]);
      flow *= weight_of(model_.state.saturation[at(flow > 0.0 ? b : a)]);
      inflow_[at(a)] += flow;
      inflow_[at(b)] -= flow;
    }
  }

  void crack(Index j) {
    const auto& joint = model_.mesh.joint[at(j)];
    const State& s = model_.state;
    const double length = model_.mesh.joint_length(j);
    const material::Fracture& f = options_.fracture[at(model_.crack.group[at(j)])];
    const auto a = at(joint.vertex[0]);
    const auto b = at(joint.vertex[1]);
    const double head_difference = s.crack_pressure[a] - s.crack_pressure[b] +
                                   options_.fluid.density * options_.gravity *
                                       (model_.mesh.vertex[a].y - model_.mesh.vertex[b].y);
    double flow = std::pow(f.initial_aperture, 3) / (12.0 * options_.fluid.viscosity) *
                  head_difference / length;
    flow *= weight_of(s.crack_saturation[flow > 0.0 ? a : b]);
    crack_inflow_[a] -= flow;
    crack_inflow_[b] += flow;
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t end = 0; end < 2; ++end) {
        const auto face = at(joint.corner[side][end]);
        const auto node = at(joint.vertex[end]);
        double leak = 0.5 * f.exchange * length * (s.crack_pressure[node] - s.pressure[face]);
        leak *= weight_of(leak > 0.0 ? s.crack_saturation[node] : s.saturation[face]);
        inflow_[face] += leak;
        crack_inflow_[node] -= leak;
      }
    }
  }

  /// A corner of each corner's node: a flood through unbroken joints when tied.
  [[nodiscard]] std::vector<Index> nodes() const {
    std::vector<Index> node(at(model_.mesh.corners()));
    std::iota(node.begin(), node.end(), 0);
    for (bool changed = options_.joints == PoreJoints::tied; changed;) {
      changed = false;
      for (Index j = 0; j < model_.mesh.joints(); ++j) {
        for (std::size_t end = 0; end < 2 && !model_.cracks.is_broken(j); ++end) {
          Index& a = node[at(model_.mesh.joint[at(j)].corner[0][end])];
          Index& b = node[at(model_.mesh.joint[at(j)].corner[1][end])];
          if (a != b) {
            a = b = std::min(a, b);
            changed = true;
          }
        }
      }
    }
    return node;
  }

  struct Store {
    double content = 0.0, storage = 0.0, voids = 0.0;
  };

  static std::pair<double, double> fluid_of(const Store& n) {
    if (n.content >= 0.0) {
      return {n.content / n.storage, 1.0};
    }
    return {0.0, 1.0 + n.content / n.voids};
  }

  [[nodiscard]] Result contents(double dt) const {
    Result result{model_.state.pressure, model_.state.saturation, model_.state.crack_pressure,
                  model_.state.crack_saturation};
    const double phi = options_.rock.porosity;
    const auto node = nodes();
    std::map<Index, Store> store;
    for (const Index c : test::corners_of(model_.mesh)) {
      const double volume = model_.mesh.area(mesh::triangle_of(c)) / 3.0;
      Store& n = store[node[at(c)]];
      const double s = model_.state.saturation[at(c)];
      const double modulus = options_.rock.biot_modulus.value_or(options_.fluid.bulk_modulus / phi);
      n.storage += volume / modulus;
      n.voids += phi * volume;
      n.content +=
          s < 1.0 ? (s - 1.0) * phi * volume : model_.state.pressure[at(c)] * volume / modulus;
      n.content += dt * inflow_[at(c)];
    }
    for (const Index c : test::corners_of(model_.mesh)) {
      std::tie(result.pressure[at(c)], result.saturation[at(c)]) = fluid_of(store[node[at(c)]]);
    }
    for (const Index v : model_.cracks.open_nodes()) {
      Store n;
      for (const Index j : model_.mesh.vertex_joints.row(v)) {
        if (model_.cracks.is_broken(j)) {
          n.voids += 0.5 * options_.fracture[at(model_.crack.group[at(j)])].initial_aperture *
                     model_.mesh.joint_length(j);
        }
      }
      n.storage = n.voids / options_.fluid.bulk_modulus;
      const double s = model_.state.crack_saturation[at(v)];
      n.content = s < 1.0 ? (s - 1.0) * n.voids : model_.state.crack_pressure[at(v)] * n.storage;
      n.content += dt * crack_inflow_[at(v)];
      std::tie(result.crack_pressure[at(v)], result.crack_saturation[at(v)]) = fluid_of(n);
    }
    return result;
  }

  const Model& model_;
  const test::FlowOptions& options_;
  std::vector<double> inflow_, crack_inflow_;
};

}  // namespace percolith::seepage::reference
