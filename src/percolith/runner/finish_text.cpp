// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/runner/finish_text.hpp"

#include "percolith/core/quantity_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <variant>

namespace percolith::runner {
namespace {

/// Whether and how `time.stop_ratio` ended a run.
std::string rest_text(const simulation::Summary& summary) {
  const auto& settlement = summary.settlement;
  if (!settlement) {
    return summary.reached_rest ? ", at rest" : "";
  }
  if (settlement->is_rest && summary.reached_rest) {
    return ", settled: the fluid is at rest";
  }
  return fmt::format(", {}: what is stored and given up is {:.2g} of what flows through",
                     summary.reached_rest ? "settled" : "not settled", settlement->change);
}

std::string end_text(const simulation::Summary& summary, bool is_steady) {
  if (is_steady) {
    return "the steady state";
  }
  return fmt::format("at time {:.6g} s after {} steps{}", summary.end_time, summary.steps,
                     rest_text(summary));
}

template <class Number>
std::optional<Number> result_of(const simulation::Summary& summary, std::string_view name) {
  const auto result =
      std::find_if(summary.mechanics.begin(), summary.mechanics.end(),
                   [&](const simulation::NamedResult& named) { return named.first == name; });
  return result == summary.mechanics.end() ? std::nullopt
                                           : std::optional(std::get<Number>(result->second));
}

std::string balance_text(const simulation::Summary& summary) {
  std::string text;
  if (summary.last.has_flow) {
    text += fmt::format(", mass balance error {:.1e}", summary.last.balance.relative_error);
  }
  if (const auto error = result_of<double>(summary, "energy_error")) {
    text += fmt::format(", energy balance error {:.1e}", *error);
  }
  return text;
}

std::string peak_text(const char* axis, double reaction, double time) {
  return fmt::format("{} {:.5g} N/m at {:.4g} s", axis, reaction, time);
}

/// What a source brought in, and the highest pressure there.
std::string source_text(const simulation::Summary& summary, const std::string& name,
                        double volume) {
  std::string text =
      fmt::format("{}: {:.4g} m2 (m3 per metre of thickness) injected", name, volume);
  const auto& peaks = summary.peak_pressures;
  const auto peak = std::find_if(peaks.begin(), peaks.end(),
                                 [&](const simulation::PeakPressure& p) { return p.name == name; });
  if (peak != peaks.end()) {
    text +=
        fmt::format(", highest pressure {} at {:.4g} s", pressure_text(peak->pressure), peak->time);
  }
  return text;
}

/// What each condition lets in or out at the end of a run of flow, a line each.
void add_rates(const simulation::Summary& summary, std::vector<std::string>& lines) {
  for (const auto& [name, rate] : summary.last.rate) {
    lines.push_back(rate == 0.0 ? fmt::format("{}: no flow", name)
                                : fmt::format("{}: {:.5g} m2/s {} the rock", name, std::abs(rate),
                                              rate > 0.0 ? "into" : "out of"));
  }
}

/// What fluid did in a coupled run, a line for each source and one for the cracks.
void add_fluid(const simulation::Summary& summary, std::vector<std::string>& lines) {
  for (const auto& [name, volume] : summary.last.balance.by_condition) {
    if (name.starts_with("source.")) {
      lines.push_back(source_text(summary, name, volume));
    }
  }
  const auto value = [&](const char* name) {
    return result_of<double>(summary, name).value_or(0.0);
  };
  if (value("crack_length_m") > 0.0) {
    const double leaked = value("leaked_m2");
    lines.push_back(fmt::format("cracks: {:.4g} m open to fluid, {:.4g} m of it full; {:.3g} "
                                "m2 {}",
                                value("crack_length_m"), value("filled_crack_length_m"),
                                std::abs(leaked),
                                leaked < 0.0 ? "came in from the rock" : "leaked into the rock"));
  }
}

}  // namespace

std::string finish_text(const simulation::Summary& summary, bool is_steady,
                        const std::filesystem::path& folder) {
  return fmt::format("finished {}{}; results in {}", end_text(summary, is_steady),
                     balance_text(summary), folder.string());
}

std::vector<std::string> result_lines(const simulation::Summary& summary) {
  std::vector<std::string> lines;
  if (summary.last.has_flow && summary.mechanics.empty()) {
    add_rates(summary, lines);
  }
  const auto count = [&](const char* name) {
    return result_of<std::int64_t>(summary, name).value_or(0);
  };
  if (!summary.mechanics.empty()) {
    lines.push_back(fmt::format("joints that broke: {} ({} in tension, {} in shear, {} mixed)",
                                count("broken_joints"), count("broken_joints_tensile"),
                                count("broken_joints_shear"), count("broken_joints_mixed")));
  }
  if (!summary.mechanics.empty() && summary.last.has_flow) {
    add_fluid(summary, lines);
  }
  for (const simulation::PeakReaction& peak : summary.peak_reactions) {
    if (peak.x != 0.0 || peak.y != 0.0) {
      lines.push_back(fmt::format("largest reaction of {}: {}, {}", peak.name,
                                  peak_text("x", peak.x, peak.x_time),
                                  peak_text("y", peak.y, peak.y_time)));
    }
  }
  return lines;
}

}  // namespace percolith::runner
