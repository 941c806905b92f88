// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/setup.hpp"

#include <span>
#include <string_view>

namespace percolith::case_file {

/// What holds, moves or presses rock at a boundary: an option, and whether a condition asks for it.
struct Support {
  std::string_view name;
  bool (*acts)(const simulation::BoundaryCondition&);
};

/// All of them.
[[nodiscard]] std::span<const Support> supports();

}  // namespace percolith::case_file
