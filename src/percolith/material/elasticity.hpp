// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/tensor2.hpp"
#include "percolith/material/elastic_rock.hpp"

namespace percolith::material {

/// Stiffness of the plane in Voigt notation, Pa: (S_xx, S_yy, S_xy) = D (E_xx, E_yy, 2 E_xy).
/// `zz_*` give the stress across the plane, zero in plane stress.
template <class Real>
struct PlaneStiffness {
  Real xx_xx, xx_yy, yy_yy, xx_xy, yy_xy, xy_xy;
};

/// Stress across the plane per in-plane strain, Pa: S_zz = xx E_xx + yy E_yy + xy 2 E_xy.
struct AcrossStiffness {
  double xx = 0.0, yy = 0.0, xy = 0.0;
};

/// Stress of a Saint Venant-Kirchhoff solid (theory.md section 8): second Piola-Kirchhoff stress
/// from Green strain, linear elasticity where strains are small, indifferent to rotation.
template <class Real>
PERCOLITH_DEVICE SymmetricTensor2<Real> stress_of(const PlaneStiffness<Real>& d,
                                                  const SymmetricTensor2<Real>& strain) {
  const Real shear = Real(2.0) * strain.xy;
  return {d.xx_xx * strain.xx + d.xx_yy * strain.yy + d.xx_xy * shear,
          d.xx_yy * strain.xx + d.yy_yy * strain.yy + d.yy_xy * shear,
          d.xx_xy * strain.xx + d.yy_xy * strain.yy + d.xy_xy * shear};
}

/// Stiffness of a rock in the axes x, y for plane strain or plane stress.
[[nodiscard]] PlaneStiffness<double> plane_stiffness(const ElasticRock& rock, Plane plane);
[[nodiscard]] AcrossStiffness across_stiffness(const ElasticRock& rock, Plane plane);

/// Modulus of the plane in uniaxial stress along x, Pa: E/(1 - nu^2) in plane strain.
[[nodiscard]] double plane_modulus(const ElasticRock& rock, Plane plane);

/// Speed of compression and shear waves, m/s; the fastest direction of layered rock.
struct WaveSpeeds {
  double compression = 0.0;
  double shear = 0.0;
};
/// `pores` (Pa) is what fluid that cannot drain adds to the stiffness, alpha^2 M.
[[nodiscard]] WaveSpeeds wave_speeds(const ElasticRock& rock, Plane plane, double pores = 0.0);

}  // namespace percolith::material
