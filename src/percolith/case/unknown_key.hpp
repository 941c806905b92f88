// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/node.hpp"
#include "percolith/core/error.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace percolith::case_file {

/// The problem of a key that the table `path` does not have: names the tables that do have it, or
/// else the nearest of the `known` names. Only what a case of `physics` has is named, everything
/// where that is "".
[[nodiscard]] InputProblem unknown_key(const Entry& entry, const std::string& path,
                                       const std::vector<std::string_view>& known,
                                       std::string_view physics);

}  // namespace percolith::case_file
