// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/simulation.hpp"
#include "percolith/simulation/task.hpp"

#include <span>

namespace percolith::simulation {

/// As the members of `Simulation` of these names; `fluid` without a model takes nothing.
void set_pore_pressure(const FluidAccess& fluid, std::span<const double> pressure);
void set_crack_pressure(const FluidAccess& fluid, std::span<const double> pressure);
void change_pressures(const FluidAccess& fluid, const PressureChange& pores,
                      const PressureChange& cracks);
[[nodiscard]] PressureMemory pressure_memory(const FluidAccess& fluid);

}  // namespace percolith::simulation
