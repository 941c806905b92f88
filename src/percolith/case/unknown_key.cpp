// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/unknown_key.hpp"

#include "percolith/case/nearest.hpp"
#include "percolith/case/option.hpp"
#include "percolith/case/option_list.hpp"

#include <fmt/format.h>

namespace percolith::case_file {

namespace {

/// The tables that have an option of this name, as they are written: `[fluid]`, `[source.NAME]`.
std::string tables_with(const std::string& name) {
  std::string tables;
  for (const std::string& path : option_paths()) {
    const std::size_t dot = path.rfind('.');
    if (dot == std::string::npos || path.compare(dot + 1, std::string::npos, name) != 0) {
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

}  // namespace

InputProblem unknown_key(const Entry& entry, const std::string& path,
                         const std::vector<std::string_view>& known) {
  std::string reason = "unknown option";
  const std::string tables = tables_with(entry.key);
  const std::string_view nearest = nearest_name(entry.key, known);
  if (!tables.empty()) {
    reason += fmt::format(" here; \"{}\" belongs in {}", entry.key, tables);
  } else if (!nearest.empty()) {
    reason += fmt::format("; the nearest valid name is \"{}\"", nearest);
  }
  return {entry.value.key_location, join_key(path, entry.key), {}, reason, listed(known)};
}

}  // namespace percolith::case_file
