// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/coupling/coupled_model.hpp"

namespace percolith::coupling {

/// Tells the flow what room the rock leaves the fluid in its present place: openings of the joints
/// of the crack network, and the growth of the pores of each triangle, which the next step of the
/// pores takes up.
void take_volumes(CoupledModel& model, Execution& execution);

}  // namespace percolith::coupling
