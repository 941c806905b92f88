// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/rules.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace percolith::case_file {

namespace {

/// The elastic energy of a layered rock is positive where 1 - nu - 2 nu_n^2 E/E_n > 0.
void check_layers(Rules& rules, const std::string& path, const material::ElasticRock& rock) {
  const std::string stiffness_key = path + ".normal_young_modulus";
  const std::string ratio_key = path + ".normal_poisson_ratio";
  const double e = rock.young_modulus;
  const double e_n = *rock.normal_young_modulus;
  const double nu_n = rock.normal_poisson_ratio.value_or(rock.poisson_ratio * e_n / e);
  const double margin = 1.0 - rock.poisson_ratio - 2.0 * nu_n * nu_n * e / e_n;
  if (!(margin > 0.0)) {
    rules.fail(
        rock.normal_poisson_ratio ? ratio_key : stiffness_key,
        {path + ".young_modulus", path + ".poisson_ratio", stiffness_key, ratio_key},
        fmt::format("the elastic energy could be negative: 1 - nu - 2 nu_n^2 E/E_n is {:.4g}",
                    margin),
        "moduli and Poisson's ratios with 1 - nu - 2 nu_n^2 E/E_n > 0");
  }
}

void check_elasticity(Rules& rules) {
  for (const auto& [name, material] : rules.setup().material) {
    const std::string path = "material." + name;
    const bool layered = material.solid.normal_young_modulus.has_value();
    if (layered) {
      check_layers(rules, path, material.solid);
    } else if (material.solid.poisson_ratio >= 0.5) {
      rules.fail(path + ".poisson_ratio", {path + ".normal_young_modulus"}, "out of range",
                 to_text(Bounds{-1.0, 0.5, false, false}, "1"));
    }
  }
}

/// A strength is lost over a range that its energy sets: both are zero or neither is.
void check_energy(Rules& rules, const std::string& path, const char* strength_name, double strength,
                  const char* energy_name, double energy) {
  if ((strength > 0.0) != (energy > 0.0)) {
    rules.fail(path + "." + energy_name, {path + "." + strength_name},
               strength > 0.0 ? fmt::format("out of range where {} is above zero", strength_name)
                              : fmt::format("has no effect where {} is zero", strength_name),
               strength > 0.0 ? "above 0 J/m2" : "0 J/m2");
  }
}

void check_strength(Rules& rules, const std::string& path, const material::JointStrength& s) {
  check_energy(rules, path, "tensile_strength", s.tensile_strength, "mode_1_energy",
               s.mode_1_energy);
  check_energy(rules, path, "cohesion", s.cohesion, "mode_2_energy", s.mode_2_energy);
}

void check_strengths(Rules& rules) {
  for (const auto& [name, material] : rules.setup().material) {
    check_strength(rules, "material." + name, material.strength);
  }
  for (const auto& [name, fracture] : rules.setup().fracture) {
    check_strength(rules, "fracture." + name, fracture.strength);
  }
}

void check_bodies(Rules& rules) {
  GroupNames regions(rules);
  for (const auto& [name, body] : rules.setup().body) {
    const std::string path = "body." + name;
    regions.add(path + ".regions", body.regions);
    if (!body.rigid && !body.initial_velocity_x && !body.initial_velocity_y) {
      rules.fail(path, {}, "has no effect: it is neither rigid nor has an initial velocity",
                 "rigid = true, initial_velocity_x or initial_velocity_y");
    }
  }
}

void check_forces(Rules& rules) {
  for (const auto& [name, force] : rules.setup().point_force) {
    if (!force.force_x && !force.force_y) {
      rules.fail_missing("point_force." + name, {}, "the force is missing",
                         "force_x, force_y or both");
    }
  }
}

void check_excavations(Rules& rules) {
  GroupNames regions(rules);
  const double end = rules.setup().time.end;
  for (const auto& [name, excavation] : rules.setup().excavation) {
    const std::string path = "excavation." + name;
    regions.add(path + ".regions", excavation.regions);
    if (excavation.start >= end) {
      rules.fail(path + ".start", {"time.end"},
                 fmt::format("{} s is not before the end of the run", excavation.start),
                 fmt::format("below {} s", end));
    }
  }
}

/// Something must stay that the openings are in.
void check_rest(Rules& rules) {
  const auto is_dug = [&](const std::string& region) {
    return std::any_of(rules.setup().excavation.begin(), rules.setup().excavation.end(),
                       [&](const auto& entry) {
                         const std::vector<std::string>& dug = entry.second.regions;
                         return std::find(dug.begin(), dug.end(), region) != dug.end();
                       });
  };
  for (const auto& [name, material] : rules.setup().material) {
    if (!std::all_of(material.regions.begin(), material.regions.end(), is_dug)) {
      return;
    }
  }
  if (!rules.setup().excavation.empty()) {
    rules.fail("excavation." + rules.setup().excavation.rbegin()->first + ".regions", {"material"},
               "leaves no rock: every region of every material is taken out",
               "regions that are a part of the model");
  }
}

void check_damping(Rules& rules) {
  const simulation::Damping& damping = rules.setup().damping;
  if (damping.element_viscosity > 0.0 && damping.viscosity_ratio > 0.0) {
    report_contradiction(rules, "damping.viscosity_ratio", "damping.element_viscosity",
                         {"element_viscosity", "viscosity_ratio"});
  }
}

}  // namespace

void check_mechanics(Rules& rules) {
  check_elasticity(rules);
  check_strengths(rules);
  check_bodies(rules);
  check_forces(rules);
  check_excavations(rules);
  check_rest(rules);
  check_damping(rules);
}

}  // namespace percolith::case_file
