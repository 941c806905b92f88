// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/report.hpp"

#include <filesystem>
#include <string>

namespace percolith::cli {

/// The last line of a run that reached its end: when it ended, how well its balance closes (of
/// mass, in mechanics of energy) and the folder with its results.
[[nodiscard]] std::string finish_text(const simulation::Summary& summary, bool is_steady,
                                      const std::filesystem::path& folder);

}  // namespace percolith::cli
