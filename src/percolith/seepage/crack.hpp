// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/device.hpp"
#include "percolith/material/fracture.hpp"

#include <algorithm>
#include <limits>

// Flow along one broken joint and between it and the rock (theory.md section 5).
namespace percolith::seepage {

/// Hydraulic aperture a = a_0 + u_n within [a_min, a_max], (28); `opening` u_n and result in m.
PERCOLITH_DEVICE double hydraulic_aperture(const material::Fracture& f, double opening) {
  return std::min(std::max(f.initial_aperture + opening, f.minimum_aperture), f.maximum_aperture);
}

/// Aperture that holds fluid: a_0 + u_n, not below a_min; not limited above (theory.md section 5),
/// or as the hydraulic one where the storage is clamped.
PERCOLITH_DEVICE double storage_aperture(const material::Fracture& f, double opening) {
  const double most =
      f.clamped_storage ? f.maximum_aperture : std::numeric_limits<double>::infinity();
  return std::min(std::max(f.initial_aperture + opening, f.minimum_aperture), most);
}

/// Conductance T/(mu L) between the two crack nodes of a broken joint (m2/(Pa s)); T is the
/// transmissivity of the group where one is given, else a^3/12 by the cubic law, (27).
PERCOLITH_DEVICE double crack_conductance(const material::Fracture& f, double aperture,
                                          double length, double mu) {
  const double transmissivity =
      f.transmissivity ? *f.transmissivity : aperture * aperture * aperture / 12.0;
  return transmissivity / (mu * length);
}

/// Conductance 1/2 h_c L between a crack node and the pore node of one facing corner, (33), (36).
PERCOLITH_DEVICE double exchange_conductance(const material::Fracture& f, double length) {
  return 0.5 * f.exchange * length;
}

}  // namespace percolith::seepage
