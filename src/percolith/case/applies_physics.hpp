// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/applies.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace percolith::case_file {

inline constexpr std::string_view needs_flow = "model.physics = \"seepage\" or \"coupled\"";
inline constexpr std::string_view needs_motion = "model.physics = \"mechanics\" or \"coupled\"";
inline constexpr std::string_view needs_coupling = "model.physics = \"coupled\"";

/// Whether there is flow, whether there is motion, in the physics of a setup: as the lists of
/// options ask, which give the name of a table too.
[[nodiscard]] bool has_flow(const simulation::Setup& setup, const std::string& name);
[[nodiscard]] bool has_motion(const simulation::Setup& setup, const std::string& name);

/// Options and tables that not every physics has.
[[nodiscard]] std::vector<Applicability> needs_of_physics();

/// Options of mechanics that need others of mechanics.
[[nodiscard]] std::vector<Applicability> needs_within_mechanics();

}  // namespace percolith::case_file
