// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/material/elasticity.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace percolith::material {
namespace {

/// Stiffness in the axes of the layers: 1 along them in the plane, 2 across, 3 along the strike.
struct LayerStiffness {
  double d11, d12, d22, d66;  // of the plane
  double d31, d32;            // stress along the strike; zero in plane stress
};

/// Inverse of the compliance of layered rock, restricted to the plane.
LayerStiffness layer_stiffness(const ElasticRock& rock, Plane plane) {
  const double e = rock.young_modulus;
  const double nu = rock.poisson_ratio;
  const double en = rock.normal_young_modulus.value_or(e);
  const double nun = rock.normal_poisson_ratio.value_or(nu * en / e);
  const double gn = rock.normal_shear_modulus.value_or(
      rock.normal_young_modulus ? 1.0 / ((1.0 + 2.0 * nun) / en + 1.0 / e)
                                : e / (2.0 * (1.0 + nu)));
  const double s11 = 1.0 / e;
  const double s13 = -nu / e;
  const double s12 = -nun / en;
  const double s22 = 1.0 / en;
  // Plane strain: stress along the strike follows from no strain there; it stiffens the compliance.
  const double share = plane == Plane::strain ? 1.0 : 0.0;
  const double b11 = s11 - share * s13 * s13 / s11;
  const double b12 = s12 - share * s13 * s12 / s11;
  const double b22 = s22 - share * s12 * s12 / s11;
  const double determinant = b11 * b22 - b12 * b12;
  LayerStiffness d{b22 / determinant, -b12 / determinant, b11 / determinant, gn, 0.0, 0.0};
  d.d31 = -share * (s13 * d.d11 + s12 * d.d12) / s11;
  d.d32 = -share * (s13 * d.d12 + s12 * d.d22) / s11;
  return d;
}

}  // namespace

PlaneStiffness<double> plane_stiffness(const ElasticRock& rock, Plane plane) {
  const LayerStiffness d = layer_stiffness(rock, plane);
  if (!rock.normal_young_modulus) {
    return {d.d11, d.d12, d.d22, 0.0, 0.0, d.d66};
  }
  const double c = std::cos(rock.bedding_angle);
  const double s = std::sin(rock.bedding_angle);
  // Rows of the map from strains in x, y to strains in the axes of the layers.
  const std::array<std::array<double, 3>, 3> t{
      {{c * c, s * s, c * s}, {s * s, c * c, -c * s}, {-2.0 * c * s, 2.0 * c * s, c * c - s * s}}};
  const auto entry = [&](std::size_t i, std::size_t j) {
    return t[0][i] * (d.d11 * t[0][j] + d.d12 * t[1][j]) +
           t[1][i] * (d.d12 * t[0][j] + d.d22 * t[1][j]) + t[2][i] * d.d66 * t[2][j];
  };
  return {entry(0, 0), entry(0, 1), entry(1, 1), entry(0, 2), entry(1, 2), entry(2, 2)};
}

AcrossStiffness across_stiffness(const ElasticRock& rock, Plane plane) {
  const LayerStiffness d = layer_stiffness(rock, plane);
  const double c = std::cos(rock.bedding_angle);
  const double s = std::sin(rock.bedding_angle);
  return {d.d31 * c * c + d.d32 * s * s, d.d31 * s * s + d.d32 * c * c, (d.d31 - d.d32) * c * s};
}

double plane_modulus(const ElasticRock& rock, Plane plane) {
  const PlaneStiffness<double> d = plane_stiffness(rock, plane);
  // Stress along x alone: eliminate the strains yy and xy.
  const double determinant = d.yy_yy * d.xy_xy - d.yy_xy * d.yy_xy;
  const double yy = (d.xx_yy * d.xy_xy - d.xx_xy * d.yy_xy) / determinant;
  const double xy = (d.xx_xy * d.yy_yy - d.xx_yy * d.yy_xy) / determinant;
  return d.xx_xx - d.xx_yy * yy - d.xx_xy * xy;
}

WaveSpeeds wave_speeds(const ElasticRock& rock, Plane plane, double pores) {
  const LayerStiffness d = layer_stiffness(rock, plane);
  return {std::sqrt((std::max(d.d11, d.d22) + pores) / rock.density),
          std::sqrt(d.d66 / rock.density)};
}

}  // namespace percolith::material
