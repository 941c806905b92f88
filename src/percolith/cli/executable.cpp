// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/cli/executable.hpp"

#include <system_error>

namespace percolith::cli {

std::filesystem::path executable_folder() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? std::filesystem::path() : program.parent_path();
}

}  // namespace percolith::cli
