// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/plausibility.hpp"

#include "percolith/case/doubts.hpp"
#include "percolith/case/plausible_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <optional>

namespace percolith::case_file {

namespace {

using simulation::Setup;

constexpr double none = Plausible::none;

const Plausible stiffness{
    "Pa", 1e6, none, "less than the 1 MPa of a soft soil", 1e12, {{"GPa", 1e9}, {"MPa", 1e6}}};
const Plausible strength{
    "Pa", 100.0, none, "less than the 100 Pa of loose sand", 1e9, {{"MPa", 1e6}, {"kPa", 1e3}}};
const Plausible density{
    "kg/m3", 500.0, 10000.0, "outside of the 500 to 10000 kg/m3 of rocks", 1e4, {{"g/cm3", 1e3}}};
const Plausible permeability{"m2", -none,
                             1e-7, "more than the 1e-7 m2 of coarse gravel",
                             1e-7, {{"mdarcy", 9.869233e-16}, {"darcy", 9.869233e-13}}};
const Plausible angle{"rad",
                      -2.0 * std::numbers::pi,
                      2.0 * std::numbers::pi,
                      "more than a full turn",
                      2.0 * std::numbers::pi,
                      {{"deg", std::numbers::pi / 180.0}}};
const Plausible energy{"J/m2", -none, 1e5, "more than the 1e5 J/m2 of the toughest rock", none, {}};
const Plausible rate{
    "m2/s", -1.0, 1.0, "more than the 1 m2/s of the largest pumps", 100.0, {{"l/s/m", 1e-3}}};
const Plausible aperture{
    "m", -none, 0.02, "more than the 20 mm of a wide fissure", 0.01, {{"mm", 1e-3}, {"um", 1e-6}}};

/// A toughness that stands for an energy is turned into one, if Young's modulus is known.
void judge_energy(const std::string& key, double value, const material::ElasticRock* solid,
                  Doubts& doubts) {
  std::string advice = " It is an energy: of a toughness K it is K^2 (1 - nu^2)/E in plane strain";
  if (solid != nullptr && solid->young_modulus > 0.0) {
    const double nu = solid->poisson_ratio;
    advice += fmt::format(", for K = {:g} Pa m^(1/2) here {:.3g} J/m2", value,
                          value * value * (1.0 - nu * nu) / solid->young_modulus);
  }
  doubts.judge(key, value, energy, advice);
}

/// `solid` is the rock of a material, null for a fracture.
void judge_strength(const std::string& path, const material::JointStrength& rock,
                    const material::ElasticRock* solid, Doubts& doubts) {
  if (rock.tensile_strength > 0.0) {
    doubts.judge(path + ".tensile_strength", rock.tensile_strength, strength);
  }
  if (rock.cohesion > 0.0) {
    doubts.judge(path + ".cohesion", rock.cohesion, strength);
  }
  judge_energy(path + ".mode_1_energy", rock.mode_1_energy, solid, doubts);
  judge_energy(path + ".mode_2_energy", rock.mode_2_energy, solid, doubts);
}

void judge_rock(const std::string& path, const simulation::Material& material, Doubts& doubts) {
  const material::ElasticRock& solid = material.solid;
  doubts.judge(path + ".density", solid.density, density);
  doubts.judge(path + ".young_modulus", solid.young_modulus, stiffness);
  doubts.judge(path + ".normal_young_modulus", solid.normal_young_modulus.value_or(0.0), stiffness);
  doubts.judge(path + ".normal_shear_modulus", solid.normal_shear_modulus.value_or(0.0), stiffness);
  doubts.judge(path + ".bedding_angle", solid.bedding_angle, angle);
  judge_strength(path, material.strength, &solid, doubts);
}

/// What a rock of solid grains has is a range; beyond it the equations still hold.
void judge_biot(const std::string& path, const simulation::Material& material, Doubts& doubts) {
  const double alpha = material.biot_coefficient;
  if (alpha < material.rock.porosity || alpha > 1.0) {
    doubts.add(path + ".biot_coefficient",
               fmt::format("is outside of the range from the porosity, {:g}, to 1 that a rock of "
                           "solid grains has",
                           material.rock.porosity));
  }
}

void judge_apertures(const Setup& setup, Doubts& doubts) {
  for (const auto& [name, group] : setup.fracture) {
    doubts.judge("fracture." + name + ".initial_aperture", group.fracture.initial_aperture,
                 aperture);
  }
  if (setup.new_cracks) {
    doubts.judge("new_cracks.initial_aperture", setup.new_cracks->fracture.initial_aperture,
                 aperture);
  }
}

void judge_rates(const Setup& setup, Doubts& doubts) {
  for (const auto& [name, source] : setup.source) {
    doubts.judge("source." + name + ".rate", source.rate.value_or(Schedule{}).largest(), rate);
  }
}

/// What would be written at times that the run does not reach.
void judge_output(const Setup& setup, Doubts& doubts) {
  const auto judge = [&](const std::string& key, const std::optional<double>& interval) {
    if (interval && setup.time.scheme != simulation::Scheme::steady && *interval > setup.time.end) {
      doubts.add(key, fmt::format("is longer than the run, which ends at time.end = {:g} s: only "
                                  "its first and its last state are written",
                                  setup.time.end));
    }
  };
  judge("output.interval", setup.output.interval);
  judge("output.history_interval", setup.output.history_interval);
}

}  // namespace

std::vector<std::string> plausibility_warnings(const Setup& setup, const KeyLocations& locations) {
  Doubts doubts(locations);
  const simulation::Physics physics = setup.model.physics;
  for (const auto& [name, material] : setup.material) {
    const std::string path = "material." + name;
    // Problems that are stated without units have a viscosity of 1.
    if (has_flow(physics) && setup.fluid.viscosity != 1.0) {
      const Tensor& k = material.rock.permeability;
      doubts.judge(path + ".permeability", std::max(k.xx, k.yy), permeability);
    }
    if (has_motion(physics)) {
      judge_rock(path, material, doubts);
    }
    if (physics == simulation::Physics::coupled) {
      judge_biot(path, material, doubts);
    }
  }
  for (const auto& [name, fracture] : setup.fracture) {
    if (has_motion(physics)) {
      judge_strength("fracture." + name, fracture.strength, nullptr, doubts);
    }
  }
  if (has_flow(physics) && setup.fluid.viscosity != 1.0) {
    judge_apertures(setup, doubts);
    judge_rates(setup, doubts);
  }
  if (has_motion(physics)) {
    judge_loads(setup, doubts);
  }
  judge_output(setup, doubts);
  return doubts.take();
}

}  // namespace percolith::case_file
