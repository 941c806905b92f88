// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/task.hpp"

#include <string>

namespace percolith::simulation {

/// As the member of `Simulation` of this name; `access` without a model has no conditions.
void set_condition(const ConditionAccess& access, const std::string& path, double value);

}  // namespace percolith::simulation
