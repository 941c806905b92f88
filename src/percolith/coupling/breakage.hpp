// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/coupling/coupled_model.hpp"

#include <vector>

namespace percolith::coupling {

/// Opens the crack network along the joints that fluid enters now: those that broke in `changes`,
/// and, where fluid enters softening joints, those past their peak. Pore nodes split, exchange goes
/// through the new faces (36), and from now on the crack presses them. Returns the joints,
/// ascending.
std::vector<Index> open_network(CoupledModel& model, const mechanics::Changes& changes);

}  // namespace percolith::coupling
