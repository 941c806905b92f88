// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/report.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace percolith::io {

/// How a run ended.
enum class Outcome { finished, interrupted, failed };

/// What a run knows beside the simulation's own summary.
struct RunRecord {
  std::string version;
  std::string case_file;
  std::string title;
  Outcome outcome = Outcome::finished;
  std::string reason;  ///< why it was interrupted or failed
  int threads = 1;
  std::string processor;
  std::vector<std::string> regions;    ///< names that `region` of the fields indexes
  std::vector<std::string> fractures;  ///< names that `fracture` of the fields indexes
  std::vector<std::string> warnings;   ///< of the case file, with their places
};

/// Text of `summary.json`: how the run ended, steps, wall time per phase, hash of the state; of
/// flow rejected steps, iterations, the mass balance and extremes, of mechanics its named results,
/// the peaks of the reactions and whether it came to rest. Keys carry units; a value that is not a
/// number becomes null. Phases of `more_wall_time` (s) are added to the simulation's.
[[nodiscard]] std::string summary_json(const RunRecord& record, const simulation::Summary& summary,
                                       const std::map<std::string, double>& more_wall_time);

/// Whether the run that left `summary.json` in a folder came to its end; false where there is none
/// that can be read.
[[nodiscard]] bool has_finished(const std::filesystem::path& folder);

/// Name of this machine's processor, "unknown" where the system does not tell.
[[nodiscard]] std::string processor_name();

}  // namespace percolith::io
