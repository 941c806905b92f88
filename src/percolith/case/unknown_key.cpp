// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/unknown_key.hpp"

#include "percolith/case/applies.hpp"
#include "percolith/case/nearest.hpp"
#include "percolith/case/option.hpp"
#include "percolith/case/option_list.hpp"

#include <fmt/format.h>

#include <algorithm>
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
  if (!tables.empty()) {
    reason += fmt::format(" here; \"{}\" belongs in {}", entry.key, tables);
  } else if (!nearest.empty()) {
    reason += fmt::format("; the nearest valid name is \"{}\"", nearest);
  }
  return {entry.value.key_location, join_key(path, entry.key), {}, reason, listed(names)};
}

}  // namespace percolith::case_file
