// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/coupling/coupled_model.hpp"

#include <span>

namespace percolith::coupling {

/// Makes a dry rock wet: it feels the pore pressure of `water` through the Biot coefficients, one
/// per region of the mesh, and the pressure in its cracks on the faces of the joints that are open
/// to the flow. What stress the rock starts from is taken as total stress: triangles and joints get
/// the effective one, so that the start is in equilibrium if it was without fluid. To be called
/// before anything has moved, with the state of the fluid at time zero.
void moisten(mechanics::Model& rock, const seepage::Model& water, std::span<const double> biot,
             JointStress joint_stress);

}  // namespace percolith::coupling
