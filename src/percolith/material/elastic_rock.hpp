// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace percolith::material {

/// How the third direction enters the plane: no strain or no stress across it.
enum class Plane { strain, stress };

/// Elasticity and mass of a rock. Isotropic, or transversely isotropic: layers (bedding,
/// schistosity) whose strike is normal to the plane of the model and that dip by `bedding_angle`.
struct ElasticRock {
  double density = 0.0;        ///< rho, kg/m3, of the bulk
  double young_modulus = 0.0;  ///< E, Pa; of layered rock: along the layers
  double poisson_ratio = 0.0;  ///< nu; of layered rock: within the layers
  /// E_n, Pa: across the layers. With it the rock is transversely isotropic.
  std::optional<double> normal_young_modulus;
  /// nu_n: shortening along the layers over extension across, under stress across; absent:
  /// nu E_n/E.
  std::optional<double> normal_poisson_ratio;
  /// G_n, Pa: shear between the layers; absent: Saint-Venant's
  /// 1/G_n = (1 + 2 nu_n)/E_n + 1/E.
  std::optional<double> normal_shear_modulus;
  double bedding_angle = 0.0;  ///< rad, of the layers from the x axis, counter-clockwise
  friend bool operator==(const ElasticRock&, const ElasticRock&) = default;
};

}  // namespace percolith::material
