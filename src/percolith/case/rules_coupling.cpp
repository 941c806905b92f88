// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/rules.hpp"

#include <fmt/format.h>

#include <algorithm>

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

/// A rock that is in balance at every step has no velocity.
void check_quasi_static(Rules& rules) {
  const Setup& setup = rules.setup();
  if (setup.time.scheme != simulation::Scheme::quasi_static) {
    return;
  }
  for (const auto& [name, condition] : setup.boundary) {
    const std::string path = "boundary." + name;
    for (const char* const option :
         {".velocity_x", ".velocity_y", ".displacement_x", ".displacement_y", ".absorbing"}) {
      if (rules.given(path + option)) {
        rules.fail(path + option, {"time.scheme"},
                   "a quasi-static run takes no motion of its boundaries",
                   "fixed, roller, loads, or time.scheme = \"explicit\"");
      }
    }
  }
  for (const auto& [name, body] : setup.body) {
    rules.fail("body." + name, {"time.scheme"}, "a quasi-static run has no bodies in motion",
               "time.scheme = \"explicit\"");
  }
  if (setup.time.stop_ratio) {
    rules.fail("time.stop_ratio", {"time.scheme"}, "a quasi-static run is at rest at every step",
               "time.balance_tolerance");
  }
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
