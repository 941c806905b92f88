// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/setup.hpp"

#include <span>
#include <string>

// What is generated from the declared options.
namespace percolith::case_file {

/// A JSON Schema (draft 2020-12) of case files, with help, unit, bounds and default of every
/// option; ends with a line break.
[[nodiscard]] std::string schema_json();

/// The reference page of all options, as Markdown.
[[nodiscard]] std::string reference_markdown();

/// A value the program worked out, for the reader of a resolved case.
struct DerivedValue {
  std::string name;
  std::string value;
  std::string unit;  ///< "" for none
};

/// A complete case file: every option with its value in SI units, defaults included; options that
/// are not given or have no effect stand in comments, and so do the derived values at the end.
/// Read again it gives the same setup, bit for bit. Files are named as in `setup`, so a caller that
/// stores the text in another directory gives them absolute paths first.
[[nodiscard]] std::string resolved_toml(const simulation::Setup& setup,
                                        std::span<const DerivedValue> derived = {});

}  // namespace percolith::case_file
