// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace percolith::cli {

/// True where `name` is neither an option nor a command of the program itself.
[[nodiscard]] bool is_external_command(std::string_view name);

/// Replaces this process by `percolith-<arguments[0]>`, next to the program or else on the PATH,
/// with the rest of the arguments. Returns only by an exception: InputError with the nearest
/// command where there is no such program, FileError where it cannot be started.
[[nodiscard]] int run_external_command(std::span<const std::string> arguments);

}  // namespace percolith::cli
