// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/unknown_key.hpp"

#include "percolith/case/applies.hpp"
#include "percolith/case/nearest.hpp"
#include "percolith/case/option.hpp"
#include "percolith/case/option_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace percolith::case_file {

namespace {

/// The tables that have an option of this name, as they are written: `[fluid]`, `[source.NAME]`.
std::string tables_with(const std::string& name, std::string_view physics) {
  std::string tables;
  for (const std::string& path : option_paths()) {
    const std::size_t dot = path.rfind('.');
    if (dot == std::string::npos || path.compare(dot + 1, std::string::npos, name) != 0 ||
        !has_option(physics, path)) {
      continue;
    }
    std::string table = path.substr(0, dot);
    if (table.back() == '*') {
      table.replace(table.size() - 1, 1, "NAME");
    }
    tables += fmt::format("{}[{}]", tables.empty() ? "" : ", ", table);
  }
  return tables;
}

/// What an option that a table has not is called there, or follows from.
struct Elsewhere {
  std::string_view table;
  std::string_view key;
  std::string_view hint;
};

constexpr std::string_view conduction_of_cracks =
    "a fracture conducts by its aperture a, as a^3/12 (cubic law): initial_aperture; "
    "transmissivity replaces that law";
constexpr std::string_view energy_of_toughness =
    "the toughness K_Ic follows from mode_1_energy G: K_Ic^2 = G E/(1 - nu^2) in plane strain";
constexpr std::array<Elsewhere, 14> known_elsewhere{{
    {"fracture", "permeability", conduction_of_cracks},
    {"fracture", "conductivity", conduction_of_cracks},
    {"fracture", "hydraulic_conductivity", conduction_of_cracks},
    {"new_cracks", "permeability", conduction_of_cracks},
    {"new_cracks", "conductivity", conduction_of_cracks},
    {"new_cracks", "hydraulic_conductivity", conduction_of_cracks},
    {"material", "fracture_toughness", energy_of_toughness},
    {"material", "toughness", energy_of_toughness},
    {"material", "K_Ic", energy_of_toughness},
    {"material", "mode_1_toughness", energy_of_toughness},
    {"fracture", "fracture_toughness", energy_of_toughness},
    {"fracture", "toughness", energy_of_toughness},
    {"fracture", "K_Ic", energy_of_toughness},
    {"fracture", "mode_1_toughness", energy_of_toughness},
}};

/// "" where nothing is known of the option.
std::string_view hint_of(const std::string& path, const std::string& key) {
  const std::string table = path.substr(0, path.find('.'));
  const auto known =
      std::find_if(known_elsewhere.begin(), known_elsewhere.end(), [&](const Elsewhere& option) {
        return option.table == table && option.key == key;
      });
  return known == known_elsewhere.end() ? std::string_view{} : known->hint;
}

/// The names that the table `path` has in a case of `physics`.
std::vector<std::string_view> names_within(const std::string& path,
                                           const std::vector<std::string_view>& known,
                                           std::string_view physics) {
  const std::size_t dot = path.find('.');
  const std::string table = dot == std::string::npos ? path : path.substr(0, dot) + ".*";
  std::vector<std::string_view> names;
  std::copy_if(known.begin(), known.end(), std::back_inserter(names),
               [&](std::string_view name) { return has_option(physics, join_key(table, name)); });
  return names;
}

}  // namespace

InputProblem unknown_key(const Entry& entry, const std::string& path,
                         const std::vector<std::string_view>& known, std::string_view physics) {
  std::string reason = "unknown option";
  const std::string tables = tables_with(entry.key, physics);
  const std::vector<std::string_view> names = names_within(path, known, physics);
  const std::string_view nearest = nearest_name(entry.key, names);
  const std::string_view hint = hint_of(path, entry.key);
  if (!hint.empty()) {
    reason += fmt::format(" here; {}", hint);
  } else if (!tables.empty()) {
    reason += fmt::format(" here; \"{}\" belongs in {}", entry.key, tables);
  } else if (!nearest.empty()) {
    reason += fmt::format("; the nearest valid name is \"{}\"", nearest);
  }
  return {entry.value.key_location, join_key(path, entry.key), {}, reason, listed(names)};
}

}  // namespace percolith::case_file
