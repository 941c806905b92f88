// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/vec2.hpp"
#include "percolith/mesh/corner.hpp"

#include <span>
#include <vector>

namespace percolith::mesh {

/// The numbers of `points` in the order in which a Hilbert curve over their bounding box visits
/// them: consecutive points are close to each other. Points in the same cell of a 65536 x 65536
/// grid keep their order.
[[nodiscard]] std::vector<Index> hilbert_order(std::span<const Point> points);

}  // namespace percolith::mesh
