// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>

namespace percolith::material {

/// What the flow needs to know of a group of fractures.
struct Fracture {
  double initial_aperture = 1e-4;  ///< a_0, m: hydraulic aperture at zero opening
  double minimum_aperture = 0.0;   ///< a_min, m
  double maximum_aperture = std::numeric_limits<double>::infinity();  ///< a_max, m
  /// Intrinsic transmissivity, m3 (permeability along the fracture times aperture); when absent
  /// the cubic law a^3/12.
  std::optional<double> transmissivity;
  /// h_c, m/(Pa s): flux from crack to one face per pressure difference; infinite: crack and faces
  /// share one pressure.
  double exchange = std::numeric_limits<double>::infinity();
  /// sigma_nref, Pa: effective normal stress that closes the fracture to a tenth of a_0; absent:
  /// a_0 does not depend on the stress.
  std::optional<double> closure_stress{};
  /// Whether the volume of a fracture is limited by the maximum aperture too, as in the paper.
  bool clamped_storage = false;
  friend bool operator==(const Fracture&, const Fracture&) = default;
};

}  // namespace percolith::material
