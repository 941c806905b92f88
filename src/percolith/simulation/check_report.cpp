// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/check_report.hpp"

#include "percolith/seepage/flow_graph.hpp"
#include "percolith/seepage/graph_conditions.hpp"
#include "percolith/seepage/step_limit.hpp"
#include "percolith/simulation/build_model.hpp"
#include "percolith/simulation/leak_off.hpp"
#include "percolith/simulation/mesh_report.hpp"
#include "percolith/simulation/pumped_mouths.hpp"
#include "percolith/simulation/steady_suction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace percolith::simulation {
namespace {

using mesh::Index;

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
    if (const auto dry = steady_suction_warning(model)) {
      warnings.push_back(*dry);
    }
    for (std::size_t i = 0; i < model.conditions.schedule.size(); ++i) {
      if (!model.conditions.schedule[i].is_constant()) {
        warnings.push_back(fmt::format("{} depends on time; a steady run uses its value at time 0",
                                       model.conditions.name[i]));
      }
    }
  }
  const auto mouths = pumped_mouth_warnings(setup, model.mesh);
  warnings.insert(warnings.end(), mouths.begin(), mouths.end());
  const auto leaks = leak_off_warnings(setup, model);
  warnings.insert(warnings.end(), leaks.begin(), leaks.end());
  return warnings;
}

CheckReport make_check_report(const Setup& setup, const seepage::Model& model,
                              std::vector<std::string> warnings) {
  CheckReport report;
  const mesh::Mesh& mesh = model.mesh;
  report.warnings = std::move(warnings);
  describe_mesh(mesh, report);
  report.broken_joints = static_cast<std::int64_t>(model.cracks.broken_joints().size());
  report.pore_nodes = static_cast<std::int64_t>(model.pore_nodes.nodes(mesh).size());
  report.crack_nodes = static_cast<std::int64_t>(model.cracks.open_nodes().size());
  const auto names = fracture_table_names(setup);
  for (const Index j : model.cracks.broken_joints()) {
    const double length = mesh.joint_length(j);
    report.fracture_length += length;
    report.fracture_length_by_group[names[at(model.crack.group[at(j)])]] += length;
  }
  add_limits(model, report);
  return report;
}

}  // namespace percolith::simulation
