// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>

namespace percolith::cli {

/// Does what the command line (without the program's name) asks and returns the exit code:
/// 0 success, 2 input, 3 solver or memory, 4 files, 130 or 143 stopped by a signal, 1 anything
/// else. Errors go to the standard error stream.
[[nodiscard]] int run_program(std::span<const std::string> arguments) noexcept;

}  // namespace percolith::cli
