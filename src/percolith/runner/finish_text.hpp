// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/report.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace percolith::runner {

/// The last line of a run that reached its end: when it ended, how well its balance closes (of
/// mass, in mechanics of energy) and the folder with its results.
[[nodiscard]] std::string finish_text(const simulation::Summary& summary, bool is_steady,
                                      const std::filesystem::path& folder);

/// What a run came to, a line each. In a run of flow the rate of each condition at its end (m2/s);
/// in mechanics joints that broke by their mode; in coupled physics what each source brought in
/// (m2) and its highest pressure, and the length of the cracks (m) with what leaked out of them
/// (m2); the largest reactions (N/m) of the boundaries and bodies that had any.
[[nodiscard]] std::vector<std::string> result_lines(const simulation::Summary& summary);

}  // namespace percolith::runner
