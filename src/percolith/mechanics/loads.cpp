// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/loads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace percolith::mechanics {
namespace {

void add(Model& model, Index corner, Point force) {
  model.loads.fx[at(corner)] += force.x;
  model.loads.fy[at(corner)] += force.y;
}

Point velocity(const Model& model, Index corner) {
  return {model.motion.vx[at(corner)], model.motion.vy[at(corner)]};
}

/// Edge of a triangle as it lies now, from its first corner to its second.
Point present_edge(const Model& model, const std::array<Index, 2>& corner) {
  const auto a = at(corner[0]);
  const auto b = at(corner[1]);
  const Point u{model.motion.ux[b] - model.motion.ux[a], model.motion.uy[b] - model.motion.uy[a]};
  return (model.mesh.place_of(corner[1]) - model.mesh.place_of(corner[0])) + u;
}

/// Pressure p (Pa) on the present edge of a triangle, -p n L, half of it at each end.
void press(Model& model, const std::array<Index, 2>& corner, double pressure) {
  const Point half = -0.5 * pressure * clockwise(present_edge(model, corner));
  add(model, corner[0], half);
  add(model, corner[1], half);
}

}  // namespace

double FadingSupport::left(double t) const {
  if (t <= start) {
    return 1.0;
  }
  return t >= start + duration ? 0.0 : 1.0 - (t - start) / duration;
}

LoadSet::LoadSet(const mesh::Mesh& mesh, LoadList list) : list_(std::move(list)) {
  find_corners(mesh);
}

void LoadSet::find_corners(const mesh::Mesh& mesh) {
  corners_.clear();
  const auto add_edge_corners = [&](const std::vector<Index>& edges) {
    for (const Index e : edges) {
      const auto& corner = mesh.boundary[at(e)].corner;
      corners_.insert(corners_.end(), corner.begin(), corner.end());
    }
  };
  for (const EdgeTraction& load : list_.traction) {
    add_edge_corners(load.edges);
  }
  for (const EdgePressure& load : list_.pressure) {
    add_edge_corners(load.edges);
  }
  const auto add_corner = [&](const auto& load) { corners_.push_back(load.corner); };
  std::for_each(list_.constant.begin(), list_.constant.end(), add_corner);
  std::for_each(list_.point.begin(), list_.point.end(), add_corner);
  std::for_each(list_.dashpot.begin(), list_.dashpot.end(), add_corner);
  for (const FadingSupport& support : list_.fading) {
    std::for_each(support.force.begin(), support.force.end(), add_corner);
    for (const auto& corners : support.wall) {
      corners_.insert(corners_.end(), corners.begin(), corners.end());
    }
  }
  std::sort(corners_.begin(), corners_.end());
  corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
  drag_.assign(list_.dashpot.size(), {});
}

void LoadSet::add_fading(const mesh::Mesh& mesh, FadingSupport support) {
  list_.fading.push_back(std::move(support));
  find_corners(mesh);
}

void LoadSet::apply(Model& model) {
  for (const Index corner : corners_) {
    model.loads.fx[at(corner)] = 0.0;
    model.loads.fy[at(corner)] = 0.0;
    model.loads.acts[at(mesh::triangle_of(corner) / block_width)] = 1;
  }
  add_edges(model);
  add_points(model);
  add_supports(model);
  const double dt = model.motion.last_step;
  for (std::size_t i = 0; i < list_.dashpot.size(); ++i) {
    const Dashpot& dashpot = list_.dashpot[i];
    const Point v = velocity(model, dashpot.corner);
    drag_[i] = -1.0 * (dashpot.resistance * v);
    add(model, dashpot.corner, drag_[i]);
    model.energy.absorbed += -0.5 * dt * dot(drag_[i], v);
  }
}

void LoadSet::add_edges(Model& model) const {
  const double t = model.motion.time;
  for (const EdgeTraction& load : list_.traction) {
    const Point traction{load.x.at(t), load.y.at(t)};
    for (const Index e : load.edges) {
      const mesh::BoundaryEdge& edge = model.mesh.boundary[at(e)];
      const Point along =
          model.mesh.vertex[at(edge.vertex[1])] - model.mesh.vertex[at(edge.vertex[0])];
      const Point half = 0.5 * std::sqrt(dot(along, along)) * traction;
      add(model, edge.corner[0], half);
      add(model, edge.corner[1], half);
    }
  }
  for (const EdgePressure& load : list_.pressure) {
    const double pressure = load.pressure.at(t);
    for (const Index e : load.edges) {
      press(model, model.mesh.boundary[at(e)].corner, pressure);
    }
  }
}

void LoadSet::add_points(Model& model) const {
  const double t = model.motion.time;
  for (const CornerForce& load : list_.constant) {
    add(model, load.corner, load.force);
  }
  for (const PointLoad& load : list_.point) {
    add(model, load.corner, load.share * Point{load.x.at(t), load.y.at(t)});
  }
}

void LoadSet::add_supports(Model& model) const {
  for (const FadingSupport& support : list_.fading) {
    const double left = support.left(model.motion.time);
    for (const CornerForce& load : support.force) {
      add(model, load.corner, left * load.force);
    }
    for (const auto& corners : support.wall) {
      press(model, corners, (1.0 - left) * support.pressure);
    }
  }
}

void LoadSet::book_absorbed(Model& model, double dt) const {
  for (std::size_t i = 0; i < list_.dashpot.size(); ++i) {
    const Point v = velocity(model, list_.dashpot[i].corner);
    model.energy.absorbed += -0.5 * dt * dot(drag_[i], v);
  }
}

std::vector<double> LoadSet::resistances(const mesh::Mesh& mesh) const {
  if (list_.dashpot.empty()) {
    return {};
  }
  std::map<Index, Tensor> at_corner;
  for (const Dashpot& dashpot : list_.dashpot) {
    Tensor& sum = at_corner[dashpot.corner];
    sum = {sum.xx + dashpot.resistance.xx, sum.yy + dashpot.resistance.yy,
           sum.xy + dashpot.resistance.xy};
  }
  std::vector<double> largest(at(mesh.triangles()), 0.0);
  for (const auto& [corner, c] : at_corner) {
    const double half = 0.5 * (c.xx - c.yy);
    double& most = largest[at(mesh::triangle_of(corner))];
    most = std::max(most, 0.5 * (c.xx + c.yy) + std::sqrt(half * half + c.xy * c.xy));
  }
  return largest;
}

double LoadSet::next_break(double t) const {
  double next = std::numeric_limits<double>::infinity();
  for (const EdgeTraction& load : list_.traction) {
    next = std::min({next, load.x.next_break(t), load.y.next_break(t)});
  }
  for (const EdgePressure& load : list_.pressure) {
    next = std::min(next, load.pressure.next_break(t));
  }
  for (const PointLoad& load : list_.point) {
    next = std::min({next, load.x.next_break(t), load.y.next_break(t)});
  }
  return next;
}

std::vector<Dashpot> absorbing_edges(const Model& model, std::span<const Index> edges) {
  std::vector<Dashpot> dashpots;
  for (const Index e : edges) {
    const mesh::BoundaryEdge& edge = model.mesh.boundary[at(e)];
    const Index triangle = mesh::triangle_of(edge.corner[0]);
    const SolidMaterial& material = model.material[at(model.triangles.material[at(triangle)])];
    // Waves leave no time to drain.
    const double pores = model.pores.stiffness.empty() ? 0.0 : model.pores.stiffness[at(triangle)];
    const auto speed = material::wave_speeds(material.rock, model.plane, pores);
    const Point along =
        model.mesh.vertex[at(edge.vertex[1])] - model.mesh.vertex[at(edge.vertex[0])];
    const double length = std::sqrt(dot(along, along));
    const Point t = (1.0 / length) * along;
    const Point n = clockwise(t);
    const double half = 0.5 * material.rock.density * length;
    const Tensor c{half * (speed.compression * n.x * n.x + speed.shear * t.x * t.x),
                   half * (speed.compression * n.y * n.y + speed.shear * t.y * t.y),
                   half * (speed.compression * n.x * n.y + speed.shear * t.x * t.y)};
    dashpots.push_back({edge.corner[0], c});
    dashpots.push_back({edge.corner[1], c});
  }
  return dashpots;
}

}  // namespace percolith::mechanics
