// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/coupling/coupled_model.hpp"

namespace percolith::coupling {

/// Gives the joints that fluid presses the pressures of their crack nodes.
void press_by(mechanics::Model& rock, const seepage::Model& water);

/// Lets the present pressures of pores and cracks act on the rock in its next step, (37) to (40).
void apply_pressures(CoupledModel& model);

}  // namespace percolith::coupling
