// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/physics.hpp"

#include "percolith/case/applies.hpp"
#include "percolith/case/option_list.hpp"
#include "percolith/case/path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace percolith::case_file {

namespace {

constexpr std::array<std::string_view, 3> all_physics{"seepage", "mechanics", "coupled"};

struct Found {
  std::string path;
  const Node* node = nullptr;
};

bool comes_first(const FileLocation& a, const FileLocation& b) {
  return a.line != b.line ? a.line < b.line : a.column < b.column;
}

/// The option at `pattern` that stands first in the file; without a node where there is none. `*`
/// is any name of a table.
Found first_written(const Node& root, const std::string& pattern) {
  const Path parts = split_path(pattern);
  const auto star = std::find(parts.begin(), parts.end(), "*");
  if (star == parts.end()) {
    return {pattern, find_at(root, parts)};
  }
  const Node* holder = find_at(root, Path(parts.begin(), star));
  Found first;
  if (holder == nullptr || holder->table() == nullptr) {
    return first;
  }
  for (const Entry& entry : holder->table()->list) {
    const Node* node = find_at(entry.value, Path(star + 1, parts.end()));
    if (node != nullptr &&
        (first.node == nullptr || comes_first(node->key_location, first.node->key_location))) {
      first = {with_name(pattern, entry.key), node};
    }
  }
  return first;
}

/// The first option in the file that seepage does not have.
Found first_beyond_seepage(const Node& root) {
  Found first;
  for (const std::string& pattern : option_paths()) {
    if (has_option("seepage", pattern)) {
      continue;
    }
    const Found found = first_written(root, pattern);
    if (found.node != nullptr && (first.node == nullptr || comes_first(found.node->key_location,
                                                                       first.node->key_location))) {
      first = found;
    }
  }
  return first;
}

/// In words: "mechanics or coupled".
std::string physics_with(const std::string& path) {
  const Path parts = split_path(path);
  std::string pattern = path;
  if (parts.size() > 2) {
    pattern = parts[0] + ".*." + parts[2];
  }
  std::string names;
  for (const std::string_view physics : all_physics) {
    if (has_option(physics, pattern)) {
      names += (names.empty() ? "" : " or ") + fmt::format("\"{}\"", physics);
    }
  }
  return names;
}

void report_missing(const Node& root, const Found& found, Problems& problems) {
  const Node* model = root.table()->find("model");
  const int line = found.node->key_location.line;  // 0 where it was not in the file
  const FileLocation place = model != nullptr ? model->key_location : root.location;
  problems.add(
      {place,
       "model.physics",
       {},
       fmt::format("required but missing: {}{} is an option of {}, and without it a case is one of "
                   "seepage",
                   found.path, line > 0 ? fmt::format(" (line {})", line) : "",
                   physics_with(found.path)),
       R"("seepage" (flow through a rock at rest), "mechanics" (a dry rock that deforms and breaks))"
       R"( or "coupled" (both))"});
}

}  // namespace

std::string_view find_physics(const Node& root, Problems& problems) {
  const Node* node = find_at(root, {"model", "physics"});
  if (node == nullptr) {
    const Found found = first_beyond_seepage(root);
    if (found.node == nullptr) {
      return "seepage";
    }
    report_missing(root, found, problems);
    return {};
  }
  for (const std::string_view physics : all_physics) {
    if (node->text() != nullptr && *node->text() == physics) {
      return physics;
    }
  }
  return {};
}

}  // namespace percolith::case_file
