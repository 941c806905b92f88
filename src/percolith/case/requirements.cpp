// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/requirements.hpp"

#include <algorithm>

namespace percolith::case_file {

namespace {

using simulation::Physics;
using simulation::Setup;

bool in_seepage(const Setup& setup, const std::string& /*name*/) {
  return setup.model.physics == Physics::seepage;
}

bool in_mechanics(const Setup& setup, const std::string& /*name*/) {
  return setup.model.physics == Physics::mechanics;
}

bool may_break(const Setup& setup, const std::string& name) {
  return in_mechanics(setup, name) &&
         setup.material.at(name).joints == simulation::RockJoints::breakable;
}

/// Whether a region of this material is part of a body.
bool is_in_body(const Setup& setup, const std::string& name) {
  const std::vector<std::string>& regions = setup.material.at(name).regions;
  return std::any_of(setup.body.begin(), setup.body.end(), [&](const auto& entry) {
    const std::vector<std::string>& others = entry.second.regions;
    return std::find_first_of(regions.begin(), regions.end(), others.begin(), others.end()) !=
           regions.end();
  });
}

bool rubs(const Setup& setup, const std::string& name) {
  return may_break(setup, name) || (in_mechanics(setup, name) && is_in_body(setup, name));
}

bool is_bonded(const Setup& setup, const std::string& name) {
  return in_mechanics(setup, name) && setup.fracture.at(name).bond == simulation::Bond::cohesive;
}

std::vector<Requirement> everything() {
  const std::vector<std::string> physics{"model.physics"};
  const std::vector<std::string> joints{"model.physics", "material.*.joints"};
  const std::vector<std::string> bond{"model.physics", "fracture.*.bond"};
  std::vector<Requirement> rules{
      {"material.*.permeability", physics, in_seepage},
      {"material.*.porosity", physics, in_seepage},
      {"fracture.*.initial_aperture", physics, in_seepage},
      {"fracture.*.exchange", physics, in_seepage},
      {"material.*.density", physics, in_mechanics},
      {"material.*.young_modulus", physics, in_mechanics},
      {"material.*.poisson_ratio", physics, in_mechanics},
      {"material.*.friction_angle", joints, rubs},
      {"fracture.*.friction_angle", bond, is_bonded},
  };
  for (const char* const option :
       {"tensile_strength", "cohesion", "mode_1_energy", "mode_2_energy"}) {
    rules.push_back({std::string("material.*.") + option, joints, may_break});
    rules.push_back({std::string("fracture.*.") + option, bond, is_bonded});
  }
  return rules;
}

const std::vector<Requirement> all = everything();

}  // namespace

std::span<const Requirement> requirements() {
  return all;
}

}  // namespace percolith::case_file
