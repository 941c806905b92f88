// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/gmsh_mesh.hpp"

#include <cstdint>

namespace percolith::bench {

/// Unit square of `n` x `n` cells, two triangles each, as a mesh file would hold it: inner points
/// moved at random by up to a fifth of a cell, points and triangles in random order, so that
/// reading it has to find an order again. Curves: `left`, `right`, and `fractures`, a network of
/// horizontal and vertical lines that cross, a tenth of the side apart. The same `seed` gives the
/// same mesh.
[[nodiscard]] mesh::GmshMesh grid_mesh(std::int32_t n, std::uint64_t seed = 1);

/// Number of cells along a side whose mesh has about `triangles` triangles.
[[nodiscard]] std::int32_t cells_for(std::int32_t triangles);

}  // namespace percolith::bench
