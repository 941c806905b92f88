// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/error.hpp"
#include "percolith/simulation/groups.hpp"
#include "percolith/simulation/solid_build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace percolith::simulation {
namespace {

using mechanics::Held;
using mechanics::PrescribedMotion;
using mesh::Index;

Point edge_vector(const mesh::Mesh& mesh, Index e) {
  const mesh::BoundaryEdge& edge = mesh.boundary[at(e)];
  return mesh.vertex[at(edge.vertex[1])] - mesh.vertex[at(edge.vertex[0])];
}

Point unit(const Point& v) {
  return (1.0 / std::sqrt(dot(v, v))) * v;
}

/// Collects what is prescribed, table by table.
class SupportList {
public:
  explicit SupportList(const mechanics::Model& model) : model_(&model) {}

  Index motion(const std::string& name, PrescribedMotion::Kind kind, const Schedule& value) {
    motions.push_back({name, kind, value});
    return static_cast<Index>(motions.size()) - 1;
  }
  void hold(Index corner, const Point& direction, Index motion) {
    held.push_back({corner, direction, motion});
  }
  /// Holds all corners that hang together with a corner round its vertex: a boundary that is fixed
  /// holds the rock behind it, but not another body that touches it there.
  void hold_fan(Index corner, const Point& direction, Index motion) {
    const auto corners = model_->mesh.vertex_corners.row(model_->mesh.vertex_of(corner));
    for (const Index c : corners) {
      if (model_->fans.leader(c) == model_->fans.leader(corner)) {
        hold(c, direction, motion);
      }
    }
  }

  std::vector<PrescribedMotion> motions;
  std::vector<Held> held;

private:
  const mechanics::Model* model_;
};

/// Normals along which a roller holds each corner of its edges: that of its edge, or the mean of
/// two edges of a smooth curve; round a sharp corner both.
std::map<Index, std::vector<Point>> roller_normals(const mechanics::Model& model,
                                                   const std::vector<Index>& edges) {
  constexpr double smooth = 0.7071;  // cosine of 45 degrees
  std::map<Index, std::vector<Point>> by_vertex;
  std::map<Index, std::vector<Index>> corners;
  for (const Index e : edges) {
    const Point normal = unit(clockwise(edge_vector(model.mesh, e)));
    for (std::size_t end = 0; end < 2; ++end) {
      const Index vertex = model.mesh.boundary[at(e)].vertex[end];
      corners[vertex].push_back(model.mesh.boundary[at(e)].corner[end]);
      std::vector<Point>& normals = by_vertex[vertex];
      if (!normals.empty() && dot(normals.back(), normal) > smooth) {
        normals.back() = unit(normals.back() + normal);
      } else {
        normals.push_back(normal);
      }
    }
  }
  std::map<Index, std::vector<Point>> by_corner;
  for (const auto& [vertex, normals] : by_vertex) {
    for (const Index corner : corners[vertex]) {
      by_corner[corner] = normals;
    }
  }
  return by_corner;
}

void hold_edges(const mechanics::Model& model, const std::vector<Index>& edges,
                const Point& direction, Index motion, SupportList& list) {
  for (const Index e : edges) {
    for (const Index corner : model.mesh.boundary[at(e)].corner) {
      list.hold_fan(corner, direction, motion);
    }
  }
}

/// The rock is undeformed at time zero: a displacement can only grow from there.
void require_start_at_zero(const std::string& key, const std::optional<Schedule>& displacement) {
  if (displacement && displacement->at(0.0) != 0.0) {
    throw InputError({{},
                      key,
                      "",
                      fmt::format("is {:g} m at time 0, where the rock is not deformed yet",
                                  displacement->at(0.0)),
                      "a table over time that begins with 0 at time 0"});
  }
}

void add_boundary(const mechanics::Model& model, const std::string& name,
                  const BoundaryCondition& b, SupportList& list) {
  const std::string path = "boundary." + name;
  require_start_at_zero(path + ".displacement_x", b.displacement_x);
  require_start_at_zero(path + ".displacement_y", b.displacement_y);
  const std::vector<Index> edges = boundary_edges(model.mesh, b.groups, path + ".groups");
  using Kind = PrescribedMotion::Kind;
  const auto along = [&](const std::optional<Schedule>& value, Kind kind, const Point& direction) {
    if (value) {
      hold_edges(model, edges, direction, list.motion(path, kind, *value), list);
    }
  };
  along(b.velocity_x, Kind::velocity, {1.0, 0.0});
  along(b.velocity_y, Kind::velocity, {0.0, 1.0});
  along(b.displacement_x, Kind::displacement, {1.0, 0.0});
  along(b.displacement_y, Kind::displacement, {0.0, 1.0});
  if (b.fixed) {
    const Index rest = list.motion(path, Kind::velocity, Schedule{});
    hold_edges(model, edges, {1.0, 0.0}, rest, list);
    hold_edges(model, edges, {0.0, 1.0}, rest, list);
  }
  if (b.roller) {
    const Index rest = list.motion(path, Kind::velocity, Schedule{});
    for (const auto& [corner, normals] : roller_normals(model, edges)) {
      for (const Point& normal : normals) {
        list.hold_fan(corner, normal, rest);
      }
    }
  }
}

void add_bodies(const Setup& setup, const mechanics::Model& model, SupportList& list) {
  const BodyRegions regions = body_regions(setup, model.mesh);
  Index number = 0;
  for (const auto& [name, body] : setup.body) {
    if (body.rigid) {
      using Kind = PrescribedMotion::Kind;
      const Index x =
          list.motion("body." + name, Kind::velocity, body.velocity_x.value_or(Schedule{}));
      const Index y =
          list.motion("body." + name, Kind::velocity, body.velocity_y.value_or(Schedule{}));
      for (Index t = 0; t < model.mesh.triangles(); ++t) {
        if (regions.body[at(model.mesh.region[at(t)])] == number) {
          for (Index k = 0; k < 3; ++k) {
            list.hold(mesh::corner_of(t, k), {1.0, 0.0}, x);
            list.hold(mesh::corner_of(t, k), {0.0, 1.0}, y);
          }
        }
      }
    }
    ++number;
  }
}

/// Forces that carry the traction of the in-situ stress over an edge; it is linear along it, and so
/// are the shares of the two corners.
void add_in_situ(const InSitu& in_situ, const mechanics::Model& model, Index e,
                 mechanics::LoadList& loads) {
  const mesh::BoundaryEdge& edge = model.mesh.boundary[at(e)];
  const Point normal = clockwise(edge_vector(model.mesh, e));  // times length
  std::array<Point, 2> traction;
  for (std::size_t end = 0; end < 2; ++end) {
    traction[end] = in_situ_stress(in_situ, model.mesh.vertex[at(edge.vertex[end])]) * normal;
  }
  for (std::size_t end = 0; end < 2; ++end) {
    loads.constant.push_back(
        {edge.corner[end], (1.0 / 3.0) * traction[end] + (1.0 / 6.0) * traction[1 - end]});
  }
}

void add_boundary_loads(const Setup& setup, const mechanics::Model& model, const std::string& name,
                        const BoundaryCondition& b, mechanics::LoadList& loads) {
  const std::vector<Index> edges =
      boundary_edges(model.mesh, b.groups, "boundary." + name + ".groups");
  if (b.traction_x || b.traction_y) {
    loads.traction.push_back(
        {edges, b.traction_x.value_or(Schedule{}), b.traction_y.value_or(Schedule{})});
  }
  if (b.normal_pressure) {
    loads.pressure.push_back({edges, *b.normal_pressure});
  }
  if (b.pressurised) {
    loads.pressure.push_back({edges, b.pressure.value_or(Schedule{})});
  }
  if (b.in_situ) {
    for (const Index e : edges) {
      add_in_situ(setup.in_situ.value_or(InSitu{}), model, e, loads);
    }
  }
  if (b.absorbing) {
    const auto dashpots = mechanics::absorbing_edges(model, edges);
    loads.dashpot.insert(loads.dashpot.end(), dashpots.begin(), dashpots.end());
  }
}

void add_point_force(const mechanics::Model& model, const std::string& name,
                     const PointForce& force, mechanics::LoadList& loads) {
  const Point place{force.point[0], force.point[1]};
  Index nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (Index v = 0; v < model.mesh.vertices(); ++v) {
    const Point gap = model.mesh.vertex[at(v)] - place;
    if (dot(gap, gap) < least) {
      least = dot(gap, gap);
      nearest = v;
    }
  }
  const auto corners = model.mesh.vertex_corners.row(nearest);
  const double reach = mechanics::element_size(model.mesh, mesh::triangle_of(corners.front()));
  if (std::sqrt(least) > reach) {
    const Point p = model.mesh.vertex[at(nearest)];
    throw InputError(
        {{},
         "point_force." + name + ".point",
         fmt::format("[{:g}, {:g}]", place.x, place.y),
         "no vertex of the mesh is near",
         fmt::format("a point on the rock; the nearest vertex is ({:.6g}, {:.6g})", p.x, p.y)});
  }
  for (const Index corner : corners) {
    loads.point.push_back({corner, 1.0 / static_cast<double>(corners.size()),
                           force.force_x.value_or(Schedule{}), force.force_y.value_or(Schedule{})});
  }
}

/// Rock in balance that nothing holds might lie anywhere: three directions at two corners far from
/// each other keep it where it is without straining it.
void hold_in_place(const mechanics::Model& model, SupportList& list) {
  const auto reach = [&](const mesh::BoundaryEdge& edge) {
    const Point& p = model.mesh.vertex[at(edge.vertex[0])];
    return p.x + p.y;
  };
  const auto [first, last] =
      std::minmax_element(model.mesh.boundary.begin(), model.mesh.boundary.end(),
                          [&](const auto& a, const auto& b) { return reach(a) < reach(b); });
  const Point between =
      model.mesh.vertex[at(last->vertex[0])] - model.mesh.vertex[at(first->vertex[0])];
  const Index rest = list.motion("held_in_place", PrescribedMotion::Kind::velocity, Schedule{});
  list.hold_fan(first->corner[0], {1.0, 0.0}, rest);
  list.hold_fan(first->corner[0], {0.0, 1.0}, rest);
  list.hold_fan(last->corner[0], unit(clockwise(between)), rest);
}

}  // namespace

mechanics::SupportSet solid_supports(const Setup& setup, mechanics::Model& model) {
  SupportList list(model);
  for (const auto& [name, boundary] : setup.boundary) {
    add_boundary(model, name, boundary, list);
  }
  add_bodies(setup, model, list);
  if (setup.time.scheme == Scheme::quasi_static && list.held.empty()) {
    hold_in_place(model, list);
  }
  return {model, std::move(list.motions), std::move(list.held)};
}

mechanics::LoadList solid_loads(const Setup& setup, const mechanics::Model& model) {
  mechanics::LoadList loads;
  for (const auto& [name, boundary] : setup.boundary) {
    add_boundary_loads(setup, model, name, boundary, loads);
  }
  for (const auto& [name, force] : setup.point_force) {
    add_point_force(model, name, force, loads);
  }
  return loads;
}

}  // namespace percolith::simulation
