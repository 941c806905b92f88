// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/coupling/options.hpp"
#include "percolith/mechanics/dynamics.hpp"
#include "percolith/seepage/model.hpp"

#include <vector>

// Rock that moves and breaks, and the fluid in its pores and cracks (paper section 4).
namespace percolith::coupling {

using mesh::Index;

struct Options {
  FluidEnters fluid_enters = FluidEnters::broken;
  /// Per joint: the fracture group of the flow that it belongs to once fluid enters.
  std::vector<Index> group;
};

/// Both halves on copies of one mesh, with the same numbers of corners, joints and vertices.
/// The halves belong to someone else and must stay where they are.
struct CoupledModel {
  mechanics::Dynamics& rock;
  seepage::Model& water;
  Options options;
};

}  // namespace percolith::coupling
