// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/coupling/coupled_model.hpp"

namespace percolith::coupling {

/// Lets the present pressures of pores and cracks act on the rock in its next step, (37) to (40).
void apply_pressures(CoupledModel& model);

}  // namespace percolith::coupling
