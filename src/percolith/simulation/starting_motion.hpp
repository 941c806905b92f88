// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/vec2.hpp"
#include "percolith/mechanics/model.hpp"

#include <vector>

namespace percolith::simulation {

/// What a dry rock starts with at time zero, per vertex; empty: nothing. Being one value a vertex,
/// it leaves joints closed. The rock stores the energy of these strains from the start.
struct StartingMotion {
  std::vector<Point> displacement;  ///< m
  std::vector<Point> velocity;      ///< m/s
  [[nodiscard]] bool empty() const { return displacement.empty() && velocity.empty(); }
};

/// Gives it to a rock that is being built. Throws InputError (key `displacement` or `velocity`) for
/// another number of values than vertices, values that are not finite, and displacements that turn
/// a triangle over.
void set_motion(mechanics::Model& rock, const StartingMotion& start);

}  // namespace percolith::simulation
