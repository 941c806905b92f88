// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/vec2.hpp"
#include "percolith/mesh/mesh.hpp"

namespace percolith::mechanics {

/// A force that stays the same, on one corner, N/m.
struct CornerForce {
  mesh::Index corner = 0;
  Point force;
};

}  // namespace percolith::mechanics
