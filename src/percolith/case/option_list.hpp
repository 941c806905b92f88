// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace percolith::case_file {

/// The dotted paths of all options of a case file; `*` stands for a name the user chooses.
[[nodiscard]] std::vector<std::string> option_paths();

/// The help of the option with that path; "" where there is none.
[[nodiscard]] std::string help_of(const std::string& path);

}  // namespace percolith::case_file
