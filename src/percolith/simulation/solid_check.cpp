// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/error.hpp"
#include "percolith/mechanics/build.hpp"
#include "percolith/simulation/crack_starts.hpp"
#include "percolith/simulation/mesh_report.hpp"
#include "percolith/simulation/resolution.hpp"
#include "percolith/simulation/solid_run.hpp"
#include "percolith/simulation/start_balance.hpp"
#include "percolith/simulation/start_strength.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace percolith::simulation {
namespace {

using mechanics::JointState;
using mesh::Index;

/// E of a body with joints on every edge over that of its triangles: 1/E_a = 1/E' + 1.73/p_f.
double apparent_share(const mechanics::Model& model) {
  double least = 1.0;
  for (Index j = 0; j < model.mesh.joints(); ++j) {
    if (model.joints.state[at(j)] == JointState::bonded) {
      const double penalty = model.joints.full_stiffness[at(j)] * model.joints.size[at(j)];
      least = std::min(least, 1.0 / (1.0 + 1.73 * mechanics::softer_modulus(model, j) / penalty));
    }
  }
  return least;
}

/// Largest share of the length of the bonded joints that runs in the directions of one lattice of
/// equilateral triangles: |mean of exp(6 i angle)|, near 0 for an irregular mesh, 1 for a lattice.
/// Joints of fractures, whose owners come after the `materials`, lie along them in any mesh. 0
/// where few joints may break.
double regularity(const mechanics::Model& model, Index materials) {
  constexpr Index many = 300;
  Index bonded = 0;
  double along = 0.0;
  double across = 0.0;
  double total = 0.0;
  for (Index j = 0; j < model.mesh.joints(); ++j) {
    if (model.joints.state[at(j)] == JointState::bonded &&
        mechanics::owner_of(model, j) < materials) {
      ++bonded;
      const double length = model.mesh.joint_length(j);
      const double angle = 6.0 * std::atan2(model.joints.ey[at(j)], model.joints.ex[at(j)]);
      along += length * std::cos(angle);
      across += length * std::sin(angle);
      total += length;
    }
  }
  return bonded > many ? std::hypot(along, across) / total : 0.0;
}

/// Curves inside the rock that no fracture table names.
std::vector<std::string> curves_without_fracture(const Setup& setup, const mesh::Mesh& mesh) {
  std::vector<std::string> names;
  for (const auto& [name, curve] : mesh.curves) {
    const auto has_name = [&, &curve_name = name](const auto& entry) {
      const auto& groups = entry.second.groups;
      return std::find(groups.begin(), groups.end(), curve_name) != groups.end();
    };
    if (!curve.joints.empty() &&
        std::none_of(setup.fracture.begin(), setup.fracture.end(), has_name)) {
      names.push_back(name);
    }
  }
  return names;
}

std::int64_t count_state(const mechanics::Model& model, JointState state) {
  const auto begin = model.joints.state.begin();
  return std::count(begin, begin + model.mesh.joints(), state);
}

/// Paths of the tables that joints have their strengths from, in the order of their owners.
std::vector<std::string> table_paths(const Setup& setup) {
  std::vector<std::string> paths = joint_kind_names(setup);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    paths[i].insert(0, i < setup.material.size() ? "material." : "fracture.");
  }
  return paths;
}

void describe_resolution(const SolidRun& run, CheckReport& report) {
  const mechanics::Model& model = run.dynamics.model();
  const std::optional<Resolution> worst = coarsest(model);
  if (!worst) {
    return;
  }
  const std::vector<CrackStart> starts = crack_starts(run.setup, model.mesh);
  if (const std::optional<Resolution> there = coarsest_at(model, starts)) {
    report.mechanics.emplace_back("cohesive length over element size where cracks start",
                                  there->ratio);
    const double distance = resolved_distance(model, starts);
    if (there->ratio >= resolved && std::isfinite(distance)) {
      report.mechanics.emplace_back("it is below 3 from this distance on (m)", distance);
    }
  }
  report.mechanics.emplace_back("smallest cohesive length over element size", worst->ratio);
  report.mechanics.emplace_back("stiffness with joints over that of the rock",
                                apparent_share(model));
}

}  // namespace

std::vector<std::string> solid_warnings(const SolidRun& run) {
  std::vector<std::string> warnings = run.probes.warnings;
  const mechanics::Model& model = run.dynamics.model();
  const std::string coarse = resolution_warning(model, crack_starts(run.setup, model.mesh));
  if (!coarse.empty()) {
    warnings.push_back(coarse);
  }
  const auto weak = start_strength_warnings(model, table_paths(run.setup));
  warnings.insert(warnings.end(), weak.begin(), weak.end());
  const auto unbalanced = start_balance_warnings(run.setup, model);
  warnings.insert(warnings.end(), unbalanced.begin(), unbalanced.end());
  constexpr double regular = 0.4;
  if (regularity(model, static_cast<Index>(run.setup.material.size())) > regular) {
    warnings.push_back(
        "the edges of the mesh run in few directions, as those of a lattice do: cracks "
        "can only follow them, and strength depends on how they lie to the load. An "
        "irregular mesh is free of that (Mesh.Algorithm = 5; in the .geo file)");
  }
  for (const std::string& name : curves_without_fracture(run.setup, model.mesh)) {
    warnings.push_back(fmt::format("the physical curve \"{}\" lies inside the rock and no fracture "
                                   "table names it: the rock is bonded there like elsewhere",
                                   name));
  }
  if (run.added_mass > 0.1) {
    warnings.push_back(fmt::format("time.mass_scaling_step adds {:.3g} times the mass of the rock: "
                                   "only states of rest keep their meaning",
                                   run.added_mass));
  }
  if (run.setup.boundary.empty() && run.setup.body.empty() && run.setup.point_force.empty() &&
      run.setup.model.gravity == 0.0 && run.setup.excavation.empty()) {
    warnings.push_back("the case has no boundary, body, point_force or excavation table and no "
                       "gravity: nothing will move");
  }
  return warnings;
}

double solid_step(const SolidRun& run) {
  if (run.limits.empty()) {
    return run.setup.time.end;
  }
  const mechanics::MotionLimit& all = run.limits.back();
  const double stable = run.setup.time.safety * all.step;
  if (run.setup.time.step && *run.setup.time.step > all.step) {
    const Point p = run.dynamics.model().mesh.triangle_centre(all.triangle);
    throw InputError(
        {{},
         "time.step",
         fmt::format("{:g} s", *run.setup.time.step),
         fmt::format("unstable: longer than the stable step of {:.4g} s, which {} rule "
                     "at ({:g}, {:g})",
                     all.step, run.limits.front().mechanism, p.x, p.y),
         fmt::format("at most {:.4g} s, or leave it out", all.step)});
  }
  return std::min(stable, run.setup.time.step.value_or(stable));
}

CheckReport solid_check(const SolidRun& run) {
  CheckReport report;
  const mechanics::Model& model = run.dynamics.model();
  report.warnings = run.summary.warnings;
  describe_mesh(model.mesh, report);
  report.broken_joints = count_state(model, JointState::closed);
  Index number = static_cast<Index>(run.setup.material.size());
  for (const std::string& name : run.fracture_names) {
    for (Index j = 0; j < model.mesh.joints(); ++j) {
      if (mechanics::owner_of(model, j) == number) {
        report.fracture_length += model.mesh.joint_length(j);
        report.fracture_length_by_group[name] += model.mesh.joint_length(j);
      }
    }
    ++number;
  }
  for (const mechanics::MotionLimit& limit : run.limits) {
    report.limits.push_back(
        {limit.mechanism, limit.step, model.mesh.triangle_centre(limit.triangle)});
  }
  report.mechanics = {
      {"bodies (parts that hang together)",
       static_cast<std::int64_t>(mechanics::find_fragments(model).area.size())},
      {"bonded joints (may break)", count_state(model, JointState::bonded)},
      {"closed joints (broken from the start, faces together)",
       count_state(model, JointState::closed)},
      {"tied joints (sides share nodes, cannot break)", count_state(model, JointState::tied)},
      {"rigid joints (within one rigid body)", count_state(model, JointState::rigid)}};
  describe_resolution(run, report);
  if (run.setup.time.mass_scaling_step) {
    report.mechanics.emplace_back("added mass over mass", run.added_mass);
  }
  return report;
}

}  // namespace percolith::simulation
