// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace percolith::cli {

/// `percolith run`
struct RunOptions {
  std::filesystem::path case_file;
  std::optional<std::filesystem::path> resume;  ///< folder to go on with, in place of a case file
  std::optional<std::filesystem::path> output;  ///< absent: named after the case file
  std::optional<int> threads;                   ///< absent: as many as OpenMP takes
  std::vector<std::string> overrides;           ///< `path.to.key=value`
  bool force = false;
  bool quiet = false;
};

/// `percolith check`
struct CheckOptions {
  std::filesystem::path case_file;
  std::vector<std::string> overrides;  ///< `path.to.key=value`
};

/// `percolith schema`
struct SchemaOptions {
  bool reference = false;  ///< the reference page instead of the JSON Schema
};

/// `percolith new`; without an example the examples are listed.
struct NewOptions {
  std::optional<std::string> example;
  std::optional<std::filesystem::path> folder;  ///< absent: named after the example
};

/// A text that answers the command line, as for `--help` and `--version`.
struct Answer {
  std::string text;
};

using Command = std::variant<RunOptions, CheckOptions, SchemaOptions, NewOptions, Answer>;

/// Names of the commands the program holds; others are programs of their own.
inline constexpr std::array<std::string_view, 4> command_names = {"run", "check", "schema", "new"};

/// Reads the command line, without the program's name. Throws InputError with what is wrong and
/// which `--help` tells more.
[[nodiscard]] Command parse_command_line(std::span<const std::string> arguments);

}  // namespace percolith::cli
