// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/coupling/coupled_model.hpp"

#include <span>
#include <string>

namespace percolith::coupling {

/// Prepares a condition of that name and pressure (Pa) for a later `drain`, and returns its number.
Index add_drainage(seepage::Model& water, const std::string& name, double pressure);

/// Lets the fluid out of triangles that were taken out of the rock: their pores, those of the walls
/// they leave and the cracks that end there have the pressure of condition `number` from now on.
/// Conditions that prescribed another pressure there give way.
void drain(CoupledModel& model, std::span<const Index> triangles, Index number);

}  // namespace percolith::coupling
