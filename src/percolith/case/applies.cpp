// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/applies.hpp"

#include "percolith/case/applies_physics.hpp"
#include "percolith/case/path.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace percolith::case_file {

namespace {

using simulation::PoreJoints;
using simulation::Scheme;
using simulation::Setup;

bool is_geometry(const std::string& file) {
  return file.size() > 4 && file.compare(file.size() - 4, 4, ".geo") == 0;
}

bool chooses_step(const Setup& setup, const std::string& /*name*/) {
  return (setup.time.scheme == Scheme::implicit || setup.time.scheme == Scheme::quasi_static) &&
         !setup.time.step;
}

bool is_quasi_static(const Setup& setup, const std::string& /*name*/) {
  return setup.time.scheme == Scheme::quasi_static;
}

bool is_explicit(const Setup& setup, const std::string& /*name*/) {
  return setup.time.scheme == Scheme::explicit_;
}

bool has_inertia(const Setup& setup, const std::string& name) {
  return !is_quasi_static(setup, name);
}

bool has_tolerance(const Setup& setup, const std::string& name) {
  return chooses_step(setup, name) || is_quasi_static(setup, name);
}

bool is_transient(const Setup& setup, const std::string& /*name*/) {
  return setup.time.scheme != Scheme::steady;
}

bool chooses_state(const Setup& setup, const std::string& name) {
  return is_transient(setup, name) && !setup.initial.steady;
}

const std::string transient = "a time.scheme other than \"steady\"";
const std::string free_state = transient + ", without initial.steady";
const std::string free_step = "time.scheme = \"implicit\" or \"quasi_static\" without time.step";

const std::vector<Applicability> of_seepage_and_run{
    {"mesh.element_size",
     {"mesh.file"},
     [](const Setup& setup, const std::string&) { return is_geometry(setup.mesh.file); },
     "a .geo file as mesh.file"},
    {"model.head_datum",
     {"model.gravity"},
     [](const Setup& setup, const std::string&) { return setup.model.gravity > 0.0; },
     "model.gravity > 0"},
    {"model.joint_factor",
     {"model.pore_joints"},
     [](const Setup& setup, const std::string&) {
       return setup.model.pore_joints == PoreJoints::finite;
     },
     "model.pore_joints = \"finite\""},
    {"boundary.*.on",
     {"boundary.*.flux"},
     [](const Setup& setup, const std::string& name) { return !setup.boundary.at(name).flux; },
     "pressure, head or seepage_face"},
    {"source.*.into",
     {"source.*.point"},
     [](const Setup& setup, const std::string& name) {
       return setup.source.at(name).point.has_value();
     },
     "a point"},
    {"probe.*.points",
     {"probe.*.from", "probe.*.to"},
     [](const Setup& setup, const std::string& name) {
       return setup.probe.at(name).from && setup.probe.at(name).to;
     },
     "from and to"},
    {"initial.steady", {"time.scheme"}, is_transient, transient},
    {"initial.pressure", {"time.scheme", "initial.steady"}, chooses_state, free_state},
    {"initial.head", {"time.scheme", "initial.steady"}, chooses_state, free_state},
    {"initial.water_table", {"time.scheme", "initial.steady"}, chooses_state, free_state},
    {"initial.saturation", {"time.scheme", "initial.steady"}, chooses_state, free_state},
    {"initial.crack_pressure", {"time.scheme", "initial.steady"}, chooses_state, free_state},
    {"initial.crack_saturation", {"time.scheme", "initial.steady"}, chooses_state, free_state},
    {"time.end", {"time.scheme"}, is_transient, transient},
    {"time.step", {"time.scheme"}, is_transient, transient},
    {"time.initial_step", {"time.scheme", "time.step"}, chooses_step, free_step},
    {"time.maximum_step", {"time.scheme", "time.step"}, chooses_step, free_step},
    {"time.tolerance", {"time.scheme", "time.step"}, has_tolerance, free_step},
    {"time.balance_tolerance", {"time.scheme"}, is_quasi_static, "time.scheme = \"quasi_static\""},
    {"time.stop_ratio", {"time.scheme"}, is_transient, transient},
    {"time.mass_scaling_step", {"time.scheme"}, has_inertia, "time.scheme = \"explicit\""},
    {"damping", {"time.scheme"}, has_inertia, "time.scheme = \"explicit\""},
    {"time.safety", {"time.scheme"}, is_explicit, "time.scheme = \"explicit\""},
    {"time.pore_flow", {"time.scheme"}, is_explicit, "time.scheme = \"explicit\""},
    {"output.times", {"time.scheme"}, is_transient, transient},
    {"output.interval", {"time.scheme"}, is_transient, transient},
    {"output.history_interval", {"time.scheme"}, is_transient, transient},
    {"output.checkpoint_interval", {"time.scheme"}, is_transient, transient},
    {"output.checkpoint_wall_interval", {"time.scheme"}, is_transient, transient},
};

std::vector<Applicability> everything() {
  std::vector<Applicability> rules = needs_of_physics();
  const std::vector<Applicability> mechanics = needs_within_mechanics();
  rules.insert(rules.end(), of_seepage_and_run.begin(), of_seepage_and_run.end());
  rules.insert(rules.end(), mechanics.begin(), mechanics.end());
  return rules;
}

const std::vector<Applicability> all = everything();

constexpr std::array<std::pair<simulation::Physics, std::string_view>, 3> physics_names{
    {{simulation::Physics::seepage, "seepage"},
     {simulation::Physics::mechanics, "mechanics"},
     {simulation::Physics::coupled, "coupled"}}};

}  // namespace

std::span<const Applicability> applicabilities() {
  return all;
}

std::string with_name(std::string pattern, const std::string& name) {
  const std::size_t star = pattern.find('*');
  if (star != std::string::npos) {
    pattern.replace(star, 1, name);
  }
  return pattern;
}

std::vector<std::string_view> physics_of(std::string_view pattern) {
  std::vector<std::string_view> names;
  for (const auto& [physics, name] : physics_names) {
    Setup setup;
    setup.model.physics = physics;
    const bool has = std::none_of(all.begin(), all.end(), [&](const Applicability& rule) {
      return rule.option == pattern && rule.needs.front() == "model.physics" &&
             !rule.holds(setup, {});
    });
    if (has) {
      names.push_back(name);
    }
  }
  return names;
}

bool has_option(std::string_view physics, std::string_view pattern) {
  const auto is_foreign = [&](const std::string& part) {
    const auto names = physics_of(part);
    return !physics.empty() && std::find(names.begin(), names.end(), physics) == names.end();
  };
  // What a table needs its options need too, and tables with names are listed by their star.
  for (std::size_t end = 0; end != std::string_view::npos;) {
    end = pattern.find('.', end + 1);
    const std::string part(pattern.substr(0, end));
    if (is_foreign(part) || is_foreign(part + ".*")) {
      return false;
    }
  }
  return true;
}

std::string why_unused(const std::string& key, const Setup& setup) {
  const Path path = split_path(key);
  const std::string name = path.size() > 1 ? path[1] : std::string();
  for (const Applicability& rule : all) {
    if (with_name(rule.option, name) == key && !rule.holds(setup, name)) {
      return rule.condition;
    }
  }
  return {};
}

}  // namespace percolith::case_file
