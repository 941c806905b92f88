// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace percolith::cli {

/// Folder of the running program, empty where the system does not tell.
[[nodiscard]] std::filesystem::path executable_folder();

}  // namespace percolith::cli
