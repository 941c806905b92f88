// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/applies.hpp"

#include <string_view>
#include <vector>

namespace percolith::case_file {

inline constexpr std::string_view needs_seepage = "model.physics = \"seepage\"";
inline constexpr std::string_view needs_mechanics = "model.physics = \"mechanics\"";

/// Options and tables that only seepage or only mechanics has.
[[nodiscard]] std::vector<Applicability> needs_of_physics();

/// Options of mechanics that need others of mechanics.
[[nodiscard]] std::vector<Applicability> needs_within_mechanics();

}  // namespace percolith::case_file
