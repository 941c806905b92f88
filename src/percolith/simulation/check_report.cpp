// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/check_report.hpp"

#include "percolith/seepage/flow_graph.hpp"
#include "percolith/seepage/graph_conditions.hpp"
#include "percolith/seepage/step_limit.hpp"
#include "percolith/simulation/build_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace percolith::simulation {
namespace {

using mesh::Index;

double angle_at(const std::array<Point, 3>& p, std::size_t k) {
  const Point a = p[(k + 1) % 3] - p[k];
  const Point b = p[(k + 2) % 3] - p[k];
  return std::atan2(cross(a, b), dot(a, b)) * 180.0 / std::numbers::pi;
}

void add_quality(const mesh::Mesh& mesh, CheckReport& report) {
  report.smallest_angle = 180.0;
  report.smallest_edge = std::numeric_limits<double>::infinity();
  for (Index t = 0; t < mesh.triangles(); ++t) {
    const auto p = mesh.triangle_points(t);
    report.area += mesh.area(t);
    report.region_area[mesh.region_names[at(mesh.region[at(t)])]] += mesh.area(t);
    for (std::size_t k = 0; k < 3; ++k) {
      const Point edge = p[(k + 1) % 3] - p[k];
      const double length = std::sqrt(dot(edge, edge));
      report.smallest_edge = std::min(report.smallest_edge, length);
      report.largest_edge = std::max(report.largest_edge, length);
      const double angle = angle_at(p, k);
      report.largest_angle = std::max(report.largest_angle, angle);
      if (angle < report.smallest_angle) {
        report.smallest_angle = angle;
        report.smallest_angle_place = p[k];
      }
    }
  }
}

void add_limits(const seepage::Model& model, CheckReport& report) {
  const seepage::FlowGraph graph = seepage::make_flow_graph(model);
  const auto conditions = seepage::make_graph_conditions(model, graph);
  report.unknowns = std::count(conditions.prescribed.begin(), conditions.prescribed.end(), 0);
  for (const seepage::FlowLimit& limit : seepage::step_limits(graph)) {
    if (limit.node != mesh::none) {
      report.limits.push_back({limit.mechanism, limit.step, graph.place(model, limit.node)});
    }
  }
}

}  // namespace

std::vector<std::string> model_warnings(const Setup& setup, const seepage::Model& model) {
  std::vector<std::string> warnings;
  const auto names = fracture_table_names(setup);
  for (std::size_t g = 0; g < names.size(); ++g) {
    const material::Fracture& f = setup.fracture.at(names[g]).fracture;
    if (f.initial_aperture < f.minimum_aperture || f.initial_aperture > f.maximum_aperture) {
      warnings.push_back(
          fmt::format("fracture.{}.initial_aperture = {:g} m is outside of its "
                      "limits; the hydraulic aperture is {:g} m",
                      names[g], f.initial_aperture,
                      std::clamp(f.initial_aperture, f.minimum_aperture, f.maximum_aperture)));
    }
  }
  if (setup.boundary.empty() && setup.source.empty()) {
    warnings.push_back(
        "the case has no boundary and no source table: every edge is impervious, and "
        "only what gravity and the initial state drive will flow");
  }
  if (setup.time.scheme == Scheme::steady) {
    for (std::size_t i = 0; i < model.conditions.schedule.size(); ++i) {
      if (!model.conditions.schedule[i].is_constant()) {
        warnings.push_back(fmt::format("{} depends on time; a steady run uses its value at time 0",
                                       model.conditions.name[i]));
      }
    }
  }
  return warnings;
}

CheckReport make_check_report(const Setup& setup, const seepage::Model& model,
                              std::vector<std::string> warnings) {
  CheckReport report;
  const mesh::Mesh& mesh = model.mesh;
  report.triangles = mesh.triangles();
  report.vertices = mesh.vertices();
  report.joints = mesh.joints();
  report.broken_joints = static_cast<std::int64_t>(model.cracks.broken_joints().size());
  report.boundary_edges = static_cast<std::int64_t>(mesh.boundary.size());
  report.pore_nodes = static_cast<std::int64_t>(model.pore_nodes.nodes(mesh).size());
  report.crack_nodes = static_cast<std::int64_t>(model.cracks.open_nodes().size());
  add_quality(mesh, report);
  const auto names = fracture_table_names(setup);
  for (const Index j : model.cracks.broken_joints()) {
    const double length = mesh.joint_length(j);
    report.fracture_length += length;
    report.fracture_length_by_group[names[at(model.crack.group[at(j)])]] += length;
  }
  add_limits(model, report);
  report.warnings = std::move(warnings);
  if (report.smallest_angle < 10.0) {
    report.warnings.push_back(fmt::format(
        "the smallest angle of the mesh is {:.1f} degree, at ({:g}, {:g}): gradients "
        "are poor there",
        report.smallest_angle, report.smallest_angle_place.x, report.smallest_angle_place.y));
  }
  return report;
}

}  // namespace percolith::simulation
