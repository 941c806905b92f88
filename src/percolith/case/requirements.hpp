// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/setup.hpp"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace percolith::case_file {

/// An option that a case must give where others have certain values.
struct Requirement {
  std::string option;              ///< path; `*` stands for the name of a table
  std::vector<std::string> needs;  ///< paths of the options that decide
  std::function<bool(const simulation::Setup&, const std::string& name)> holds;
};

/// All options that are required, but not always.
[[nodiscard]] std::span<const Requirement> requirements();

}  // namespace percolith::case_file
