// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/setup.hpp"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace percolith::case_file {

/// An option or a table that has an effect only where options have certain values.
struct Applicability {
  std::string option;              ///< path; `*` stands for the name of a table
  std::vector<std::string> needs;  ///< paths of the options that decide
  std::function<bool(const simulation::Setup&, const std::string& name)> holds;
  std::string condition;  ///< in words: `time.scheme = "explicit"`
};

/// All options and tables that do not always have an effect. Those that need other physics come
/// first.
[[nodiscard]] std::span<const Applicability> applicabilities();

/// The physics in which the option or table at the path `pattern` has an effect; all of them where
/// it always has one.
[[nodiscard]] std::vector<std::string_view> physics_of(std::string_view pattern);

/// Whether a case of the physics has the option or table at the path `pattern`; true for every one
/// where `physics` is "".
[[nodiscard]] bool has_option(std::string_view physics, std::string_view pattern);

/// What the option or table at `key` would need to have an effect in this setup; "" where it has
/// one.
[[nodiscard]] std::string why_unused(const std::string& key, const simulation::Setup& setup);

/// `pattern` with `*` replaced by `name`.
[[nodiscard]] std::string with_name(std::string pattern, const std::string& name);

}  // namespace percolith::case_file
