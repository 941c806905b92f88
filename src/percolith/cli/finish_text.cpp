// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/cli/finish_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace percolith::cli {
namespace {

std::string end_text(const simulation::Summary& summary, bool is_steady) {
  if (is_steady) {
    return "the steady state";
  }
  return fmt::format("at time {:.6g} s after {} steps{}", summary.end_time, summary.steps,
                     summary.reached_rest ? ", at rest" : "");
}

std::string balance_text(const simulation::Summary& summary) {
  if (summary.mechanics.empty()) {
    return fmt::format(", mass balance error {:.1e}", summary.last.balance.relative_error);
  }
  const auto error = std::find_if(
      summary.mechanics.begin(), summary.mechanics.end(),
      [](const simulation::NamedValue& value) { return value.first == "energy_error"; });
  return error == summary.mechanics.end()
             ? ""
             : fmt::format(", energy balance error {:.1e}", error->second);
}

}  // namespace

std::string finish_text(const simulation::Summary& summary, bool is_steady,
                        const std::filesystem::path& folder) {
  return fmt::format("finished {}{}; results in {}", end_text(summary, is_steady),
                     balance_text(summary), folder.string());
}

}  // namespace percolith::cli
