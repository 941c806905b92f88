// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/summary.hpp"

#include <nlohmann/json.hpp>

#include <fstream>
#include <utility>
#include <variant>

namespace percolith::io {
namespace {

using Json = nlohmann::ordered_json;

const char* outcome_name(Outcome outcome) {
  switch (outcome) {
  case Outcome::finished:
    return "finished";
  case Outcome::interrupted:
    return "interrupted";
  case Outcome::failed:
    break;
  }
  return "failed";
}

Json mass_balance(const simulation::MassBalance& balance) {
  return {{"in_m2", balance.in},
          {"out_m2", balance.out},
          {"stored_m2", balance.stored},
          {"in_place_m2", balance.in_place},
          {"error_m2", balance.error},
          {"relative_error", balance.relative_error},
          {"by_condition_m2", balance.by_condition}};
}

Json extremes(const simulation::HistoryRow& last) {
  Json values = {{"minimum_pressure_Pa", last.minimum_pressure},
                 {"maximum_pressure_Pa", last.maximum_pressure},
                 {"minimum_saturation", last.minimum_saturation}};
  if (last.minimum_crack_pressure && last.maximum_crack_pressure) {
    values["minimum_crack_pressure_Pa"] = *last.minimum_crack_pressure;
    values["maximum_crack_pressure_Pa"] = *last.maximum_crack_pressure;
  }
  return values;
}

void add_flow(Json& json, const simulation::Summary& summary) {
  json["rejected_steps"] = summary.rejected_steps;
  json["iterations"] = summary.iterations;
  json["mass_balance"] = mass_balance(summary.last.balance);
  json["throughput_m2_per_s"] = summary.throughput;
  json["rate_m2_per_s"] = summary.last.rate;
  json["extremes"] = extremes(summary.last);
}

Json mechanics(const simulation::Summary& summary) {
  Json object = Json::object();
  for (const auto& [name, value] : summary.mechanics) {
    std::visit([&, &key = name](auto number) { object[key] = number; }, value);
  }
  Json peaks = Json::object();
  for (const simulation::PeakReaction& peak : summary.peak_reactions) {
    peaks[peak.name] = {{"x_N_per_m", peak.x},
                        {"x_time_s", peak.x_time},
                        {"y_N_per_m", peak.y},
                        {"y_time_s", peak.y_time}};
  }
  object["peak_reactions"] = std::move(peaks);
  if (!summary.peak_pressures.empty()) {
    Json pressures = Json::object();
    for (const simulation::PeakPressure& peak : summary.peak_pressures) {
      pressures[peak.name] = {{"pressure_Pa", peak.pressure}, {"time_s", peak.time}};
    }
    object["peak_pressures"] = std::move(pressures);
  }
  return object;
}

}  // namespace

std::string summary_json(const RunRecord& record, const simulation::Summary& summary,
                         const std::map<std::string, double>& more_wall_time) {
  std::map<std::string, double> wall_time = summary.wall_time;
  for (const auto& [phase, seconds] : more_wall_time) {
    wall_time[phase] += seconds;
  }
  Json json;
  json["version"] = record.version;
  json["case_file"] = record.case_file;
  json["title"] = record.title;
  json["outcome"] = outcome_name(record.outcome);
  json["reason"] = record.reason;
  json["end_time_s"] = summary.end_time;
  json["steps"] = summary.steps;
  json["wall_time_s"] = wall_time;
  if (summary.last.has_flow) {
    add_flow(json, summary);
  }
  if (summary.settlement) {
    json["reached_rest"] = summary.reached_rest;
    json["change_over_throughput"] = summary.settlement->change;
  }
  if (!summary.mechanics.empty()) {
    json["reached_rest"] = summary.reached_rest;
    json["mechanics"] = mechanics(summary);
  }
  json["state_hash"] = summary.state_hash;
  std::vector<std::string> warnings = record.warnings;
  warnings.insert(warnings.end(), summary.warnings.begin(), summary.warnings.end());
  json["warnings"] = warnings;
  json["regions"] = record.regions;
  json["fractures"] = record.fractures;
  json["threads"] = record.threads;
  json["processor"] = record.processor;
  // Names come from files and need not be UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

bool has_finished(const std::filesystem::path& folder) {
  std::ifstream file(folder / "summary.json");
  const Json summary = Json::parse(file, nullptr, false);
  return summary.is_object() && summary.contains("outcome") &&
         summary["outcome"] == outcome_name(Outcome::finished);
}

std::string processor_name() {
  std::ifstream information("/proc/cpuinfo");
  const std::string key = "model name";
  for (std::string line; std::getline(information, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with(key) && colon != std::string::npos) {
      return line.substr(colon + 2);
    }
  }
  return "unknown";
}

}  // namespace percolith::io
