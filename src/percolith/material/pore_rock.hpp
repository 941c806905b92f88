// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/tensor2.hpp"

#include <optional>

namespace percolith::material {

/// What the flow needs to know of a porous rock.
struct PoreRock {
  Tensor permeability{1e-15, 1e-15, 0.0};  ///< k, m2
  double porosity = 0.1;                   ///< phi, 1
  /// M, Pa; when absent K_w/phi (rigid grains and pores filled with the fluid).
  std::optional<double> biot_modulus;
  friend bool operator==(const PoreRock&, const PoreRock&) = default;
};

}  // namespace percolith::material
