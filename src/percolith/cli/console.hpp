// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/error.hpp"
#include "percolith/runner/console.hpp"

#include <string_view>

// What the program says to the person who started it.
namespace percolith::cli {

/// Writes `text` to the standard output at once. Throws FileError where it cannot be written,
/// except where its reader has gone.
void print(std::string_view text);

/// Writes `text` as a line to the standard error stream.
void print_line_to_stderr(std::string_view text);

/// Tells an error: problems of the input as they are, others after `error: `.
void print_error(const Error& error);
void print_error(std::string_view message);

/// What a run is to speak to: the standard output and the standard error stream.
[[nodiscard]] runner::Console program_console();

}  // namespace percolith::cli
