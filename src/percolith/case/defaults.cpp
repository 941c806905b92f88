// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/defaults.hpp"

#include <algorithm>

namespace percolith::case_file {

namespace {

using simulation::Setup;

/// A crack that is pressed shut must keep some room: without any the fluid in it is infinitely
/// stiff. Where stress closes it by a law of its own, which reaches a tenth at its reference, the
/// bound lies well below that.
double default_minimum(const material::Fracture& fracture) {
  const double share = fracture.closure_stress ? 0.01 : 0.1;
  return std::min(share * fracture.initial_aperture, fracture.maximum_aperture);
}

void choose_minimum_apertures(Setup& setup, const KeyLocations& locations) {
  for (auto& [name, group] : setup.fracture) {
    if (!locations.given("fracture." + name + ".minimum_aperture")) {
      group.fracture.minimum_aperture = default_minimum(group.fracture);
    }
  }
  if (setup.new_cracks && !locations.given("new_cracks.minimum_aperture")) {
    setup.new_cracks->fracture.minimum_aperture = default_minimum(setup.new_cracks->fracture);
  }
}

}  // namespace

void choose_defaults(Setup& setup, const KeyLocations& locations) {
  // Motion has one scheme that a case need not name.
  if (simulation::has_motion(setup.model.physics) && !locations.given("time.scheme")) {
    setup.time.scheme = simulation::Scheme::explicit_;
  }
  if (setup.model.physics == simulation::Physics::coupled) {
    choose_minimum_apertures(setup, locations);
  }
  if (setup.time.scheme == simulation::Scheme::quasi_static) {
    setup.time.balance_tolerance = simulation::balance_tolerance(setup.time);
  }
}

}  // namespace percolith::case_file
