// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/plausible_loads.hpp"

#include "percolith/simulation/holds_rock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

namespace percolith::case_file {

namespace {

using simulation::Setup;

constexpr std::string_view too_small = "less than the 100 Pa of 1 cm of water";
const std::vector<UsualUnit> usual_units{{"MPa", 1e6}, {"kPa", 1e3}};
const Plausible pushed{"Pa", 100.0, Plausible::none, too_small, 1e9, usual_units};
const Plausible pulled{"Pa", -Plausible::none, -100.0, too_small, 1e9, usual_units};

/// A load of zero is meant.
void judge_load(const std::string& key, double load, Doubts& doubts) {
  if (load != 0.0) {
    doubts.judge(key, load, load > 0.0 ? pushed : pulled);
  }
}

void judge_load(const std::string& key, const std::optional<Schedule>& schedule, Doubts& doubts) {
  judge_load(key, schedule.value_or(Schedule{}).largest(), doubts);
}

void judge_boundaries(const Setup& setup, Doubts& doubts) {
  for (const auto& [name, boundary] : setup.boundary) {
    const std::string path = "boundary." + name;
    judge_load(path + ".traction_x", boundary.traction_x, doubts);
    judge_load(path + ".traction_y", boundary.traction_y, doubts);
    judge_load(path + ".normal_pressure", boundary.normal_pressure, doubts);
    if (boundary.pressurised) {
      judge_load(path + ".pressure", boundary.pressure, doubts);
    }
  }
}

bool varies(const simulation::InSitu& s) {
  return s.gradient_xx != 0.0 || s.gradient_yy != 0.0 || s.gradient_xy != 0.0;
}

/// Whether a fluid presses with about one of the stresses, or with what may be one at some depth.
bool bears(const simulation::BoundaryCondition& condition, const simulation::InSitu& s) {
  constexpr double about = 0.1;
  const double pressure = condition.pressure.value_or(Schedule{}).at(0.0);
  const auto is_about = [&](double stress) {
    return stress != 0.0 && std::abs(pressure + stress) <= about * std::abs(stress);
  };
  return condition.pressurised &&
         (is_about(s.stress_xx) || is_about(s.stress_yy) || (varies(s) && pressure != 0.0));
}

/// Whether there is stress in the plane.
bool presses(const simulation::InSitu& s) {
  return s.stress_xx != 0.0 || s.stress_yy != 0.0 || s.stress_xy != 0.0 || varies(s);
}

/// Whether something holds the edges of rock that is under stress, at least somewhere.
bool is_held(const Setup& setup) {
  const bool has_platen = std::any_of(setup.body.begin(), setup.body.end(),
                                      [](const auto& entry) { return entry.second.rigid; });
  return has_platen ||
         std::any_of(setup.boundary.begin(), setup.boundary.end(), [&](const auto& entry) {
           return bears(entry.second, *setup.in_situ) ||
                  (!entry.second.pressurised && simulation::holds_rock(entry.second));
         });
}

void judge_stress(const std::string& key, double stress, Doubts& doubts) {
  if (stress > 0.0) {
    doubts.add(key, fmt::format("is tension of {:g} Pa. Is that meant? Stresses are positive in "
                                "tension; compression has a minus sign",
                                stress));
  } else if (stress < 0.0) {
    judge_load(key, stress, doubts);
  }
}

void judge_gradient(const std::string& key, double gradient, Doubts& doubts) {
  if (gradient < 0.0) {
    doubts.add(key, "says that compression falls with depth. Is that meant? Elevation counts "
                    "upwards and stresses are positive in tension: compression that grows with "
                    "depth has a positive gradient");
  }
}

void judge_in_situ(const Setup& setup, Doubts& doubts) {
  if (!setup.in_situ) {
    return;
  }
  judge_stress("in_situ.stress_xx", setup.in_situ->stress_xx, doubts);
  judge_stress("in_situ.stress_yy", setup.in_situ->stress_yy, doubts);
  judge_gradient("in_situ.gradient_xx", setup.in_situ->gradient_xx, doubts);
  judge_gradient("in_situ.gradient_yy", setup.in_situ->gradient_yy, doubts);
  if (presses(*setup.in_situ) && !is_held(setup)) {
    doubts.add("in_situ", "is held by no boundary: the rock springs apart when the run starts. A "
                          "boundary with in_situ = true carries these stresses on");
  }
}

/// Compression across the cracks that it keeps shut least, Pa.
double least_compression(const simulation::InSitu& s) {
  const double mean = 0.5 * (s.stress_xx + s.stress_yy);
  return -(mean + std::hypot(0.5 * (s.stress_xx - s.stress_yy), s.stress_xy));
}

/// Rock that in-situ stress presses together, and that fluid is to open. What is the stress at the
/// cracks is not known where it varies.
void judge_entry(const Setup& setup, Doubts& doubts) {
  const std::string key = "model.fluid_enters";
  const bool is_pumped =
      !setup.source.empty() || std::any_of(setup.boundary.begin(), setup.boundary.end(),
                                           [](const auto& b) { return b.second.pressurised; });
  if (doubts.given(key) || !setup.in_situ || varies(*setup.in_situ) || !setup.new_cracks ||
      !is_pumped) {
    return;
  }
  double strength_of_rock = Plausible::none;
  for (const auto& [name, material] : setup.material) {
    if (material.joints == simulation::RockJoints::breakable) {
      strength_of_rock = std::min(strength_of_rock, material.strength.tensile_strength);
    }
  }
  const double compression = least_compression(*setup.in_situ);
  if (compression > 0.5 * strength_of_rock) {
    doubts.add(key,
               fmt::format("is not written, so fluid enters broken joints alone. Under an in-situ "
                           "compression of {:g} Pa, against a tensile strength of {:g} Pa, "
                           "the softening joints ahead of a crack then stay dry and are pressed "
                           "together: the rock resists more than its fracture energy says. "
                           "\"softening\" lets fluid into them; \"broken\" keeps them dry",
                           compression, strength_of_rock));
  }
}

}  // namespace

void judge_loads(const Setup& setup, Doubts& doubts) {
  judge_boundaries(setup, doubts);
  judge_in_situ(setup, doubts);
  judge_entry(setup, doubts);
}

}  // namespace percolith::case_file
