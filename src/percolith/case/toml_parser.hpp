// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/node.hpp"

#include <string>
#include <string_view>

namespace percolith::case_file {

/// Parses a TOML 1.0 document into a table; `file` goes into the locations. Throws InputError with
/// line and column where it is not valid TOML or not UTF-8.
[[nodiscard]] Node parse_toml(std::string_view text, const std::string& file);

}  // namespace percolith::case_file
