// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace percolith::case_file {

namespace {

using simulation::Setup;

/// Whether joints may break, so that cracks open.
bool may_crack(const Setup& setup) {
  return std::any_of(setup.material.begin(), setup.material.end(), [](const auto& entry) {
    return entry.second.joints == simulation::RockJoints::breakable;
  });
}

void check_new_cracks(Rules& rules) {
  const Setup& setup = rules.setup();
  if (may_crack(setup) && !setup.new_cracks) {
    rules.fail("new_cracks", {},
               "required but missing: joints may break, and the flow in the "
               "cracks that open then is not told",
               "a table [new_cracks] with initial_aperture and exchange");
  }
}

void check_pressurised(Rules& rules) {
  for (const auto& [name, condition] : rules.setup().boundary) {
    const std::string path = "boundary." + name;
    if (condition.pressurised && !condition.pressure) {
      rules.fail(path + ".pressurised", {path + ".pressure"}, "the boundary has no pressure",
                 "pressure = ... beside it, or normal_pressure for a load on the rock alone");
    }
  }
}

/// Cracks that open empty would suck their faces together.
void check_cavitation(Rules& rules) {
  const Setup& setup = rules.setup();
  if (setup.fluid.cavitation_pressure == -infinite &&
      (may_crack(setup) || !setup.fracture.empty())) {
    rules.fail("fluid.cavitation_pressure", {"model.physics"},
               "a fluid that never empties a void would tear at the faces of cracks that open",
               "a finite pressure, such as 0");
  }
}

/// What would set a boundary in motion, and whether a condition asks for it: a flag may be written
/// out as false.
struct BoundaryMotion {
  std::string_view option;
  bool (*acts)(const simulation::BoundaryCondition&);
};

constexpr std::array<BoundaryMotion, 5> boundary_motions{{
    {"velocity_x", [](const auto& c) { return c.velocity_x.has_value(); }},
    {"velocity_y", [](const auto& c) { return c.velocity_y.has_value(); }},
    {"displacement_x", [](const auto& c) { return c.displacement_x.has_value(); }},
    {"displacement_y", [](const auto& c) { return c.displacement_y.has_value(); }},
    {"absorbing", [](const auto& c) { return c.absorbing; }},
}};

/// A rock that is in balance at every step has no velocity.
void check_motion_from_outside(Rules& rules) {
  const Setup& setup = rules.setup();
  for (const auto& [name, condition] : setup.boundary) {
    for (const BoundaryMotion& motion : boundary_motions) {
      if (motion.acts(condition)) {
        rules.fail(join_key("boundary." + name, motion.option), {"time.scheme"},
                   "a quasi-static run takes no motion of its boundaries",
                   "fixed, roller, loads, or time.scheme = \"explicit\"");
      }
    }
  }
  for (const auto& [name, body] : setup.body) {
    rules.fail("body." + name, {"time.scheme"}, "a quasi-static run has no bodies in motion",
               "time.scheme = \"explicit\"");
  }
}

/// The pressure of a node that cracks and pores share would be worked out anew from its content in
/// each iteration, which then starts from another pressure than the last one found.
void check_exchange(Rules& rules, const std::string& path, const material::Fracture& fracture) {
  if (fracture.exchange == infinite) {
    rules.fail(join_key(path, "exchange"), {"time.scheme"},
               "the quasi-static scheme cannot give fracture and rock one pressure",
               "a finite exchange");
  }
}

/// Pressures do not settle below what an unbalanced force moves them by.
void check_tolerances(Rules& rules) {
  const simulation::Stepping& time = rules.setup().time;
  const double most = simulation::largest_balance_share * time.tolerance;
  if (time.balance_tolerance && *time.balance_tolerance > most) {
    rules.fail("time.balance_tolerance", {"time.tolerance"},
               fmt::format("forces out of balance so far keep the pressures from settling to {:g}",
                           time.tolerance),
               fmt::format("at most {:g}, or a larger time.tolerance", most));
  }
}

void check_quasi_static(Rules& rules) {
  const Setup& setup = rules.setup();
  if (setup.time.scheme != simulation::Scheme::quasi_static) {
    return;
  }
  check_motion_from_outside(rules);
  if (setup.time.stop_ratio) {
    rules.fail("time.stop_ratio", {"time.scheme"}, "a quasi-static run is at rest at every step",
               "time.balance_tolerance");
  }
  for (const auto& [name, group] : setup.fracture) {
    check_exchange(rules, "fracture." + name, group.fracture);
  }
  if (setup.new_cracks) {
    check_exchange(rules, "new_cracks", setup.new_cracks->fracture);
  }
  check_tolerances(rules);
}

/// Rock into which a pump goes on pushing fluid never comes to rest.
void check_stop_ratio(Rules& rules) {
  const Setup& setup = rules.setup();
  const auto refuse_beside = [&](const std::string& key, const std::optional<Schedule>& rate) {
    if (setup.time.stop_ratio && rate && rate->at(setup.time.end) != 0.0) {
      rules.fail("time.stop_ratio", {"time.end", key},
                 "fluid still flows by " + key + " when the run ends, so it never comes to rest",
                 "a schedule that ends with 0 there, or time.end alone");
    }
  };
  for (const auto& [name, source] : setup.source) {
    refuse_beside("source." + name + ".rate", source.rate);
  }
  for (const auto& [name, condition] : setup.boundary) {
    refuse_beside("boundary." + name + ".flux", condition.flux);
  }
}

void check_plane(Rules& rules) {
  if (rules.setup().model.plane == simulation::Plane::stress) {
    rules.fail("model.plane", {"model.physics"},
               "coupled physics is in plane strain: fluid could leave a plate through its sides",
               "\"strain\"");
  }
}

}  // namespace

void check_coupling(Rules& rules) {
  check_new_cracks(rules);
  check_pressurised(rules);
  check_cavitation(rules);
  check_plane(rules);
  check_quasi_static(rules);
  check_stop_ratio(rules);
}

}  // namespace percolith::case_file
