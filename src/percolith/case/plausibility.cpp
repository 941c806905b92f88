// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/plausibility.hpp"

#include "percolith/case/node.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <string_view>
#include <utility>

namespace percolith::case_file {

namespace {

using simulation::Setup;

constexpr double none = std::numeric_limits<double>::infinity();

/// A unit in which a number is often thought, and what it is in SI.
struct UsualUnit {
  std::string_view name;
  double factor = 1.0;
};

/// What rocks have of a quantity, in SI.
struct Plausible {
  std::string_view unit;
  double least = -none;
  double most = none;
  std::string_view range;    ///< what is wrong beyond it, in words
  double usual_most = none;  ///< of values in the units in which they are often thought
  std::vector<UsualUnit> usual;
};

const Plausible stiffness{
    "Pa", 1e6, none, "less than the 1 MPa of a soft soil", 1e12, {{"GPa", 1e9}, {"MPa", 1e6}}};
const Plausible strength{
    "Pa", 100.0, none, "less than the 100 Pa of loose sand", 1e9, {{"MPa", 1e6}, {"kPa", 1e3}}};
const Plausible density{
    "kg/m3", 500.0, 10000.0, "outside of the 500 to 10000 kg/m3 of rocks", 1e4, {{"g/cm3", 1e3}}};
const Plausible permeability{"m2", -none,
                             1e-6, "more than the 1e-6 m2 of coarse gravel",
                             1e-6, {{"mdarcy", 9.869233e-16}, {"darcy", 9.869233e-13}}};
const Plausible angle{"rad",
                      -2.0 * std::numbers::pi,
                      2.0 * std::numbers::pi,
                      "more than a full turn",
                      2.0 * std::numbers::pi,
                      {{"deg", std::numbers::pi / 180.0}}};

bool holds(const Plausible& range, double value) {
  return value >= range.least && value <= range.most;
}

/// Collects warnings of options whose values are outside of what rocks have.
class Doubts {
public:
  explicit Doubts(const KeyLocations& locations) : locations_(locations) {}

  /// Judges the `value` (SI) of the option `key`, if it was written.
  void judge(const std::string& key, double value, const Plausible& range) {
    if (locations_.given(key) && !holds(range, value)) {
      add(key, fmt::format("is {:g} {}, {}. {}", value, range.unit, range.range,
                           question(key, value, range)));
    }
  }
  void add(const std::string& key, const std::string& doubt) {
    const Written written = locations_.nearest(key);
    warnings_.emplace_back(written.location.line,
                           fmt::format("{}: warning: {}{} {}", to_text(written.location), key,
                                       written.value.empty() ? "" : " = " + written.value, doubt));
  }
  /// In the order of the file.
  [[nodiscard]] std::vector<std::string> take() {
    std::stable_sort(warnings_.begin(), warnings_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string> texts;
    for (auto& [line, text] : warnings_) {
      texts.push_back(std::move(text));
    }
    return texts;
  }

private:
  /// Asks whether the value is meant; a number without a unit may be one of a usual unit.
  [[nodiscard]] std::string question(const std::string& key, double value,
                                     const Plausible& range) const {
    const std::string& text = locations_.nearest(key).value;
    const bool has_unit = text.find_first_of("\"'[{") != std::string::npos;
    const auto unit = std::find_if(range.usual.begin(), range.usual.end(), [&](const auto& usual) {
      const double usually = value * usual.factor;
      return holds(range, usually) && usually <= range.usual_most;
    });
    if (has_unit || unit == range.usual.end()) {
      return "Is that meant?";
    }
    const std::string usual = fmt::format("{:g} {}", value, unit->name);
    return fmt::format("Is that meant? A number without a unit is in {}; {} is written \"{}\"",
                       range.unit, usual, usual);
  }

  const KeyLocations& locations_;
  std::vector<std::pair<int, std::string>> warnings_;  // with their lines
};

void judge_strength(const std::string& path, const material::JointStrength& rock, Doubts& doubts) {
  if (rock.tensile_strength > 0.0) {
    doubts.judge(path + ".tensile_strength", rock.tensile_strength, strength);
  }
  if (rock.cohesion > 0.0) {
    doubts.judge(path + ".cohesion", rock.cohesion, strength);
  }
}

void judge_rock(const std::string& path, const simulation::Material& material, Doubts& doubts) {
  const material::ElasticRock& solid = material.solid;
  doubts.judge(path + ".density", solid.density, density);
  doubts.judge(path + ".young_modulus", solid.young_modulus, stiffness);
  doubts.judge(path + ".normal_young_modulus", solid.normal_young_modulus.value_or(0.0), stiffness);
  doubts.judge(path + ".normal_shear_modulus", solid.normal_shear_modulus.value_or(0.0), stiffness);
  doubts.judge(path + ".bedding_angle", solid.bedding_angle, angle);
  judge_strength(path, material.strength, doubts);
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
      judge_strength("fracture." + name, fracture.strength, doubts);
    }
  }
  return doubts.take();
}

}  // namespace percolith::case_file
