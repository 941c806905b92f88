// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/dynamics.hpp"
#include "percolith/simulation/setup.hpp"

#include <string>
#include <vector>

namespace percolith::simulation {

/// What acts on the rock through one boundary or body table, and how far that part has moved.
struct BoundaryState {
  std::string name;    ///< `boundary.NAME` or `body.NAME`
  Point force;         ///< N/m, on the rock: of supports and of loads
  Point displacement;  ///< m, mean over its corners
};

/// All boundary tables, then the rigid bodies, in the order of their names. Forces of supports are
/// those of the last step, loads those of the present time and place.
[[nodiscard]] std::vector<BoundaryState> boundary_states(const Setup& setup,
                                                         const mechanics::Dynamics& dynamics);

}  // namespace percolith::simulation
