// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/setup.hpp"

#include <span>
#include <string_view>

namespace percolith::simulation {

/// What holds, moves or presses rock at a boundary: an option, and whether a condition asks for it.
struct Support {
  std::string_view name;
  bool (*acts)(const BoundaryCondition&);
};

/// All of them.
[[nodiscard]] std::span<const Support> supports();

/// Whether a condition keeps rock that is under stress from springing apart. Edges that only absorb
/// waves give way, and a load of zero at all times is none.
[[nodiscard]] bool holds_rock(const BoundaryCondition& condition);

}  // namespace percolith::simulation
