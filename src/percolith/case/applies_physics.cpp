// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/applies_physics.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace percolith::case_file {

namespace {

using simulation::Physics;
using simulation::Setup;

constexpr std::array<std::string_view, 24> of_flow{{
    "model.head_datum",
    "model.pore_joints",
    "model.joint_factor",
    "model.saturation_weight",
    "fluid",
    "material.*.permeability",
    "material.*.porosity",
    "material.*.biot_modulus",
    "fracture.*.initial_aperture",
    "fracture.*.minimum_aperture",
    "fracture.*.maximum_aperture",
    "fracture.*.transmissivity",
    "fracture.*.exchange",
    "boundary.*.pressure",
    "boundary.*.head",
    "boundary.*.flux",
    "boundary.*.seepage_face",
    "boundary.*.on",
    "source.*",
    "initial",
    "probe.*.in",
    "time.initial_step",
    "time.maximum_step",
    "time.tolerance",
}};

constexpr std::array<std::string_view, 44> of_motion{{
    "model.plane",
    "material.*.density",
    "material.*.young_modulus",
    "material.*.poisson_ratio",
    "material.*.normal_young_modulus",
    "material.*.normal_poisson_ratio",
    "material.*.normal_shear_modulus",
    "material.*.bedding_angle",
    "material.*.joints",
    "material.*.tensile_strength",
    "material.*.cohesion",
    "material.*.friction_angle",
    "material.*.residual_friction_angle",
    "material.*.mode_1_energy",
    "material.*.mode_2_energy",
    "material.*.joint_penalty",
    "material.*.weibull_modulus",
    "material.*.weibull_seed",
    "fracture.*.bond",
    "fracture.*.tensile_strength",
    "fracture.*.cohesion",
    "fracture.*.friction_angle",
    "fracture.*.residual_friction_angle",
    "fracture.*.mode_1_energy",
    "fracture.*.mode_2_energy",
    "fracture.*.joint_penalty",
    "boundary.*.fixed",
    "boundary.*.roller",
    "boundary.*.displacement_x",
    "boundary.*.displacement_y",
    "boundary.*.velocity_x",
    "boundary.*.velocity_y",
    "boundary.*.traction_x",
    "boundary.*.traction_y",
    "boundary.*.normal_pressure",
    "boundary.*.in_situ",
    "boundary.*.absorbing",
    "body.*",
    "point_force.*",
    "in_situ",
    "excavation.*",
    "damping",
    "contact",
    "time.mass_scaling_step",
}};

constexpr std::array<std::string_view, 11> of_coupling{{
    "model.joint_stress",
    "model.fluid_enters",
    "model.crack_storage",
    "material.*.biot_coefficient",
    "new_cracks",
    "boundary.*.pressurised",
    "excavation.*.pressure",
    "excavation.*.pressurised",
    "fracture.*.closure_stress",
    "time.balance_tolerance",
    "time.pore_flow",
}};

bool is_coupled(const Setup& setup, const std::string& /*name*/) {
  return setup.model.physics == Physics::coupled;
}

bool is_breakable(const Setup& setup, const std::string& name) {
  return setup.material.at(name).joints == simulation::RockJoints::breakable;
}

/// Whether joints between triangles may break.
bool may_crack(const Setup& setup, const std::string& /*name*/) {
  return std::any_of(setup.material.begin(), setup.material.end(), [](const auto& entry) {
    return entry.second.joints == simulation::RockJoints::breakable;
  });
}

/// Whether joints may break, those of cohesive fractures among them.
bool may_break(const Setup& setup, const std::string& name) {
  return may_crack(setup, name) ||
         std::any_of(setup.fracture.begin(), setup.fracture.end(), [](const auto& entry) {
           return entry.second.bond == simulation::Bond::cohesive;
         });
}

/// Whether the aperture that conducts, or that which holds, is limited by the maximum.
bool has_limit(const Setup& setup, const material::Fracture& fracture) {
  return !fracture.transmissivity || setup.model.crack_storage == simulation::CrackStorage::clamped;
}

/// Whether some crack has a largest aperture.
bool has_maximum(const Setup& setup, const std::string& /*name*/) {
  const auto is_limited = [](const auto& group) {
    return std::isfinite(group.fracture.maximum_aperture);
  };
  return (setup.new_cracks && is_limited(*setup.new_cracks)) ||
         std::any_of(setup.fracture.begin(), setup.fracture.end(),
                     [&](const auto& entry) { return is_limited(entry.second); });
}

bool is_layered(const Setup& setup, const std::string& name) {
  return setup.material.at(name).solid.normal_young_modulus.has_value();
}

bool is_cohesive(const Setup& setup, const std::string& name) {
  return setup.fracture.at(name).bond == simulation::Bond::cohesive;
}

bool is_rigid(const Setup& setup, const std::string& name) {
  return setup.body.at(name).rigid;
}

bool is_free(const Setup& setup, const std::string& name) {
  return !is_rigid(setup, name);
}

bool has_gradient(const Setup& setup, const std::string& /*name*/) {
  const auto& stress = setup.in_situ;
  return stress && (stress->gradient_xx != 0.0 || stress->gradient_yy != 0.0 ||
                    stress->gradient_xy != 0.0 || stress->gradient_zz != 0.0);
}

bool is_plane_strain(const Setup& setup, const std::string& /*name*/) {
  return setup.model.plane == simulation::Plane::strain;
}

void add_materials(std::vector<Applicability>& rules) {
  const std::string breakable = "joints = \"breakable\"";
  for (const char* const option :
       {"tensile_strength", "cohesion", "residual_friction_angle", "mode_1_energy", "mode_2_energy",
        "joint_penalty", "weibull_modulus"}) {
    rules.push_back(
        {std::string("material.*.") + option, {"material.*.joints"}, is_breakable, breakable});
  }
  rules.push_back({"material.*.weibull_seed",
                   {"material.*.joints", "material.*.weibull_modulus"},
                   [](const Setup& setup, const std::string& name) {
                     return is_breakable(setup, name) &&
                            setup.material.at(name).weibull_modulus.has_value();
                   },
                   "weibull_modulus"});
  for (const char* const option :
       {"normal_poisson_ratio", "normal_shear_modulus", "bedding_angle"}) {
    rules.push_back({std::string("material.*.") + option,
                     {"material.*.normal_young_modulus"},
                     is_layered,
                     "normal_young_modulus"});
  }
}

void add_fractures(std::vector<Applicability>& rules) {
  for (const char* const option :
       {"tensile_strength", "cohesion", "mode_1_energy", "mode_2_energy", "joint_penalty"}) {
    rules.push_back({std::string("fracture.*.") + option,
                     {"fracture.*.bond"},
                     is_cohesive,
                     "bond = \"cohesive\""});
  }
}

void add_coupling(std::vector<Applicability>& rules) {
  const std::string breakable = "a rock with joints = \"breakable\"";
  const std::string breaks = breakable + ", or a fracture with bond = \"cohesive\"";
  rules.push_back({"new_cracks", {"material"}, may_crack, breakable});
  rules.push_back({"model.fluid_enters", {"material", "fracture"}, may_break, breaks});
  rules.push_back({"model.joint_stress", {"material", "fracture"}, may_break, breaks});
  rules.push_back({"model.crack_storage",
                   {"fracture", "new_cracks"},
                   has_maximum,
                   "a fracture or new cracks with a finite maximum_aperture"});
  const std::string limit = "the cubic law, or model.crack_storage = \"clamped\"";
  rules.push_back({"fracture.*.maximum_aperture",
                   {"fracture.*.transmissivity", "model.crack_storage"},
                   [](const Setup& setup, const std::string& name) {
                     return has_limit(setup, setup.fracture.at(name).fracture);
                   },
                   limit});
  rules.push_back({"new_cracks.maximum_aperture",
                   {"new_cracks.transmissivity", "model.crack_storage"},
                   [](const Setup& setup, const std::string&) {
                     return setup.new_cracks && has_limit(setup, setup.new_cracks->fracture);
                   },
                   limit});
  rules.push_back({"excavation.*.pressurised",
                   {"excavation.*.pressure"},
                   [](const Setup& setup, const std::string& name) {
                     return setup.excavation.at(name).pressure != 0.0;
                   },
                   "a pressure other than 0"});
}

}  // namespace

bool has_flow(const Setup& setup, const std::string& /*name*/) {
  return simulation::has_flow(setup.model.physics);
}

bool has_motion(const Setup& setup, const std::string& /*name*/) {
  return simulation::has_motion(setup.model.physics);
}

std::vector<Applicability> needs_of_physics() {
  std::vector<Applicability> rules;
  const auto add = [&](const auto& options, const auto& holds, std::string_view condition) {
    for (const std::string_view option : options) {
      rules.push_back({std::string(option), {"model.physics"}, holds, std::string(condition)});
    }
  };
  add(of_flow, has_flow, needs_flow);
  add(of_motion, has_motion, needs_motion);
  add(of_coupling, is_coupled, needs_coupling);
  return rules;
}

std::vector<Applicability> needs_within_mechanics() {
  std::vector<Applicability> rules;
  add_materials(rules);
  add_fractures(rules);
  add_coupling(rules);
  for (const char* const option : {"velocity_x", "velocity_y"}) {
    rules.push_back({std::string("body.*.") + option, {"body.*.rigid"}, is_rigid, "rigid = true"});
    rules.push_back(
        {std::string("body.*.initial_") + option, {"body.*.rigid"}, is_free, "rigid = false"});
  }
  rules.push_back(
      {"in_situ.datum",
       {"in_situ.gradient_xx", "in_situ.gradient_yy", "in_situ.gradient_xy", "in_situ.gradient_zz"},
       has_gradient,
       "a gradient"});
  for (const char* const option : {"stress_zz", "gradient_zz"}) {
    rules.push_back({std::string("in_situ.") + option,
                     {"model.plane"},
                     is_plane_strain,
                     "model.plane = \"strain\""});
  }
  return rules;
}

}  // namespace percolith::case_file
