// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/index.hpp"
#include "percolith/core/simd.hpp"

#include <cstdint>

// A corner is a triangle's own copy of one of its vertices. Corners are numbered so that the same
// local corner of eight consecutive triangles lies in eight consecutive slots (AoSoA-8).
namespace percolith::mesh {

using percolith::Index;
inline constexpr Index none = -1;
inline constexpr Index corners_per_block = 3 * block_width;

/// Slot of local corner `k` (0..2) of a triangle.
PERCOLITH_DEVICE Index corner_of(Index triangle, Index k) {
  return triangle / block_width * corners_per_block + k * block_width + triangle % block_width;
}
PERCOLITH_DEVICE Index triangle_of(Index corner) {
  return corner / corners_per_block * block_width + corner % block_width;
}
/// Local number (0..2) of a corner in its triangle.
PERCOLITH_DEVICE Index local_of(Index corner) {
  return corner % corners_per_block / block_width;
}
/// Number of corner slots of `triangles` triangles, padding included.
PERCOLITH_DEVICE Index corner_slots(Index triangles) {
  return 3 * padded(triangles);
}

}  // namespace percolith::mesh
