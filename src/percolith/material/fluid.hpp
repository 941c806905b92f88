// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace percolith::material {

/// The fluid in pores and cracks: slightly compressible, Newtonian.
struct Fluid {
  double density = 1000.0;      ///< rho_w, kg/m3
  double viscosity = 1e-3;      ///< mu, Pa s
  double bulk_modulus = 2.2e9;  ///< K_w, Pa
  /// p_cav, Pa: the pressure at which voids begin to empty; minus infinity: always saturated.
  double cavitation_pressure = 0.0;
  friend bool operator==(const Fluid&, const Fluid&) = default;
};

}  // namespace percolith::material
