// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace percolith::mesh {

/// What a program left behind.
struct ProgramResult {
  bool found = false;  ///< false: there is no such program
  int exit_code = 0;   ///< 128 + signal when a signal ended it
  std::string output;  ///< standard output and standard error, mixed
};

/// Runs a program, looked up on the PATH unless its name holds a slash, without a shell and with
/// empty standard input, and waits for its end. `command` holds its name and arguments. Throws
/// FileError when the system cannot start it for another reason than its absence.
[[nodiscard]] ProgramResult run_program(const std::vector<std::string>& command);

}  // namespace percolith::mesh
