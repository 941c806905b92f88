// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/requirements.hpp"

#include "percolith/case/applies_physics.hpp"

#include <algorithm>

namespace percolith::case_file {

namespace {

using simulation::Setup;

bool breaks(const Setup& setup, const std::string& name) {
  return has_motion(setup, name) &&
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
  return breaks(setup, name) || (has_motion(setup, name) && is_in_body(setup, name));
}

bool is_bonded(const Setup& setup, const std::string& name) {
  return has_motion(setup, name) && setup.fracture.at(name).bond == simulation::Bond::cohesive;
}

bool has_new_cracks(const Setup& setup, const std::string& /*name*/) {
  return setup.new_cracks.has_value();
}

std::vector<Requirement> all_requirements() {
  const std::vector<std::string> physics{"model.physics"};
  const std::vector<std::string> joints{"model.physics", "material.*.joints"};
  const std::vector<std::string> bond{"model.physics", "fracture.*.bond"};
  std::vector<Requirement> rules{
      {"material.*.permeability", physics, has_flow},
      {"material.*.porosity", physics, has_flow},
      {"fracture.*.initial_aperture", physics, has_flow},
      {"fracture.*.exchange", physics, has_flow},
      {"new_cracks.initial_aperture", {"new_cracks"}, has_new_cracks},
      {"new_cracks.exchange", {"new_cracks"}, has_new_cracks},
      {"material.*.density", physics, has_motion},
      {"material.*.young_modulus", physics, has_motion},
      {"material.*.poisson_ratio", physics, has_motion},
      {"material.*.friction_angle", joints, rubs},
      {"fracture.*.friction_angle", bond, is_bonded},
  };
  for (const char* const option :
       {"tensile_strength", "cohesion", "mode_1_energy", "mode_2_energy"}) {
    rules.push_back({std::string("material.*.") + option, joints, breaks});
    rules.push_back({std::string("fracture.*.") + option, bond, is_bonded});
  }
  return rules;
}

const std::vector<Requirement> required = all_requirements();

}  // namespace

std::span<const Requirement> requirements() {
  return required;
}

}  // namespace percolith::case_file
