// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/key_locations.hpp"
#include "percolith/case/problems.hpp"
#include "percolith/case/renames.hpp"
#include "percolith/case/units.hpp"
#include "percolith/simulation/setup.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace percolith::case_file {

/// A case file as read and checked: a complete setup in SI units.
struct Case {
  simulation::Setup setup;
  KeyLocations locations;             ///< where each given option stands
  std::vector<std::string> warnings;  ///< `file:line:col: warning: ...`
  std::filesystem::path directory;    ///< files named in the case are relative to it
};

/// Reads and checks a case file. Each of `overrides` is `path.to.key=value`, where the value is
/// TOML or a bare text, and replaces or adds that option; an empty value takes it out.
/// Throws InputErrors with every problem found, FileError where the file cannot be read.
[[nodiscard]] Case read_case(const std::filesystem::path& file,
                             std::span<const std::string> overrides = {});

/// As read_case, for a text already in memory; `file` appears in messages, and files named in the
/// text are relative to its directory. `renames` lists the old option names still understood.
[[nodiscard]] Case read_case_text(std::string_view text, const std::filesystem::path& file,
                                  std::span<const std::string> overrides = {},
                                  std::span<const Rename> renames = renamed_options());

/// As read_case_text, with units that a caller who reads many cases keeps: reading their database
/// takes longer than reading a case.
[[nodiscard]] Case read_case_text(std::string_view text, const std::filesystem::path& file,
                                  std::span<const std::string> overrides,
                                  std::span<const Rename> renames, Units& units);

/// The same error with what the case file adds to it: the location of its key, or of the table
/// that would hold it, and the value written there. An error that has a location is left as it is.
[[nodiscard]] InputError locate(const InputError& error, const Case& known);

}  // namespace percolith::case_file
