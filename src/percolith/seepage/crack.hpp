// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/device.hpp"
#include "percolith/material/fracture.hpp"

#include <algorithm>
#include <limits>

// Flow along one broken joint and between it and the rock (theory.md section 5).
namespace percolith::seepage {

/// Aperture (m) at zero opening: a_0, or of a fracture that its stress closes, with a_0 at no
/// stress, a_0/(1 + 9 sigma_n'/sigma_nref) (of the type of Barton and Bandis). `compression` is the
/// effective normal stress sigma_n' on closed faces, Pa.
PERCOLITH_DEVICE double residual_aperture(const material::Fracture& f, double compression) {
  return f.closure_stress ? f.initial_aperture / (1.0 + 9.0 * compression / *f.closure_stress)
                          : f.initial_aperture;
}

/// Hydraulic aperture a = a_0 + u_n within [a_min, a_max], (28); `opening` u_n and result in m.
PERCOLITH_DEVICE double hydraulic_aperture(const material::Fracture& f, double opening,
                                           double compression = 0.0) {
  return std::min(std::max(residual_aperture(f, compression) + opening, f.minimum_aperture),
                  f.maximum_aperture);
}

/// Aperture that holds fluid: a_0 + u_n, not below a_min; not limited above (theory.md section 5),
/// or as the hydraulic one where the storage is clamped.
PERCOLITH_DEVICE double storage_aperture(const material::Fracture& f, double opening,
                                         double compression = 0.0) {
  const double most =
      f.clamped_storage ? f.maximum_aperture : std::numeric_limits<double>::infinity();
  return std::min(std::max(residual_aperture(f, compression) + opening, f.minimum_aperture), most);
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
