// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/setup.hpp"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace percolith::case_file {

/// An option that has an effect only where others have certain values.
struct Applicability {
  std::string option;              ///< path; `*` stands for the name of a table
  std::vector<std::string> needs;  ///< paths of the options that decide
  std::function<bool(const simulation::Setup&, const std::string& name)> holds;
  std::string condition;  ///< in words: `time.scheme = "explicit"`
};

/// All options that do not always have an effect.
[[nodiscard]] std::span<const Applicability> applicabilities();

/// What the option at `key` would need to have an effect in this setup; "" where it has one.
[[nodiscard]] std::string why_unused(const std::string& key, const simulation::Setup& setup);

/// `pattern` with `*` replaced by `name`.
[[nodiscard]] std::string with_name(std::string pattern, const std::string& name);

}  // namespace percolith::case_file
