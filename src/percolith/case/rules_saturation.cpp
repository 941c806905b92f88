// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/rules.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace percolith::case_file {

namespace {

using simulation::Initial;

const std::string cavitation_key = "fluid.cavitation_pressure";

/// Voids empty at the cavitation pressure, so that no pressure can be lower.
void check_pressure(Rules& rules, const std::string& key, double pressure) {
  const double cavitation = rules.setup().fluid.cavitation_pressure;
  if (pressure < cavitation) {
    rules.fail(key, {cavitation_key},
               fmt::format("{} Pa is below the cavitation pressure", pressure),
               fmt::format(">= {} Pa, or a lower {}", cavitation, cavitation_key));
  }
}

void check_pressure(Rules& rules, const std::string& key, const std::optional<Schedule>& schedule) {
  if (schedule) {
    check_pressure(rules, key, *std::min_element(schedule->value.begin(), schedule->value.end()));
  }
}

/// A void that is not full has the cavitation pressure.
void check_partial(Rules& rules, const std::string& key, const std::optional<double>& saturation,
                   const std::string& pressure_key, const std::optional<double>& pressure) {
  const double cavitation = rules.setup().fluid.cavitation_pressure;
  if (!saturation || *saturation == 1.0) {
    return;
  }
  if (cavitation == -infinite) {
    rules.fail(key, {cavitation_key}, "the fluid never empties a void",
               "1, or a finite " + cavitation_key);
  } else if (pressure && *pressure > cavitation) {
    rules.fail(key, {cavitation_key, pressure_key},
               fmt::format("a void that is not full has the cavitation pressure, {} Pa, not {} Pa",
                           cavitation, *pressure),
               "1, or " + pressure_key + " at the cavitation pressure");
  }
}

void check_initial_saturation(Rules& rules) {
  const Initial& initial = rules.setup().initial;
  if (!initial.head && !initial.water_table) {
    check_pressure(rules, "initial.pressure", initial.pressure.value_or(0.0));
  }
  if (initial.crack_pressure) {
    check_pressure(rules, "initial.crack_pressure", *initial.crack_pressure);
  }
  check_partial(rules, "initial.saturation", initial.saturation, "initial.pressure",
                initial.pressure);
  check_partial(rules, "initial.crack_saturation", initial.crack_saturation,
                "initial.crack_pressure", initial.crack_pressure);
}

}  // namespace

void check_saturation(Rules& rules) {
  for (const auto& [name, condition] : rules.setup().boundary) {
    check_pressure(rules, "boundary." + name + ".pressure", condition.pressure);
    check_pressure(rules, "boundary." + name + ".seepage_face", condition.seepage_face);
  }
  for (const auto& [name, source] : rules.setup().source) {
    check_pressure(rules, "source." + name + ".pressure", source.pressure);
  }
  const bool starts_steady =
      rules.setup().time.scheme == simulation::Scheme::steady || rules.setup().initial.steady;
  if (!starts_steady) {
    check_initial_saturation(rules);
  }
}

}  // namespace percolith::case_file
