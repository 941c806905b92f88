// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/overrides.hpp"

#include "percolith/case/nearest.hpp"
#include "percolith/case/option.hpp"
#include "percolith/case/path.hpp"
#include "percolith/case/toml_parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace percolith::case_file {

namespace {

const FileLocation override_location{"--set", 0, 0};

void refuse(Problems& problems, const std::string& key, const std::string& value,
            std::string reason, std::string allowed) {
  problems.add({override_location, key, value, std::move(reason), std::move(allowed)});
}

void relocate(Node& node) {
  node.location = override_location;
  node.key_location = override_location;
  if (auto* list = std::get_if<Array>(&node.value)) {
    std::for_each(list->begin(), list->end(), relocate);
  } else if (Entries* entries = node.table()) {
    for (Entry& entry : entries->list) {
      relocate(entry.value);
    }
  }
}

/// True where only TOML can be meant, so that a mistake in it must be told.
bool must_be_toml(std::string_view text) {
  constexpr std::string_view openings = "[{\"'";
  return openings.find(text.front()) != std::string_view::npos;
}

/// The value as a node; throws InputError where it should be TOML but is not.
Node read_value(const std::string& text) {
  Node value;
  value.value = text;
  try {
    Node document = parse_toml("value = " + text, override_location.file);
    if (document.table()->list.size() == 1 && document.table()->list.front().key == "value") {
      value = std::move(document.table()->list.front().value);
    }
  } catch (const InputError&) {
    if (must_be_toml(text)) {
      throw;
    }
  }
  relocate(value);
  return value;
}

void apply(Node& root, const std::string& text, Problems& problems) {
  const std::size_t equals = text.find('=');
  const std::string key = trimmed(std::string_view(text).substr(0, equals));
  const std::vector<std::string> path = split_path(key);
  if (equals == std::string::npos || !is_plain_path(path)) {
    refuse(problems, {}, {}, "cannot read " + to_toml(text), "path.to.key=value");
    return;
  }
  const std::string value = trimmed(std::string_view(text).substr(equals + 1));
  const std::string holder = first_non_table(root, path);
  if (!holder.empty()) {
    refuse(problems, key, value, "\"" + holder + "\" is not a table", {});
  } else if (value.empty()) {
    erase_at(root, path);
  } else {
    try {
      Node node = read_value(value);
      set_at(root, path, std::move(node));
    } catch (const InputError& error) {
      refuse(problems, key, value, error.problem().reason, "a TOML value, or a bare text");
    }
  }
}

bool made_by_override(const Entry& entry) {
  return entry.value.key_location.file == override_location.file;
}

/// What is wrong with a table that lacks `missing`, of which the file has one named `nearest`.
std::string no_such_table(std::string_view nearest, const std::string& path,
                          const std::vector<InputProblem>& missing) {
  std::string lacks;
  for (const InputProblem& problem : missing) {
    lacks += lacks.empty() ? "" : ", ";
    lacks += problem.key == path
                 ? problem.allowed  // one of several options
                 : fmt::format("\"{}\"", std::string_view(problem.key).substr(path.size() + 1));
  }
  return fmt::format("the file has no such table; the nearest name is \"{}\"; a new one lacks {}",
                     nearest, lacks);
}

void suggest_in(const Entry& kind, Problems& problems) {
  std::vector<std::string_view> of_file;
  for (const Entry& entry : kind.value.table()->list) {
    if (!made_by_override(entry)) {
      of_file.push_back(entry.key);
    }
  }
  for (const Entry& entry : kind.value.table()->list) {
    const std::string_view nearest = nearest_name(entry.key, of_file);
    if (!made_by_override(entry) || nearest.empty()) {
      continue;
    }
    const std::string path = join_key(kind.key, entry.key);
    const std::vector<InputProblem> missing = problems.take_missing(path);
    if (!missing.empty()) {
      refuse(problems, path, {}, no_such_table(nearest, path, missing), {});
    }
  }
}

}  // namespace

void suggest_tables(const Node& root, Problems& problems) {
  for (const Entry& kind : root.table()->list) {
    if (kind.value.table() != nullptr) {
      suggest_in(kind, problems);
    }
  }
}

void apply_overrides(Node& root, std::span<const std::string> overrides, Problems& problems) {
  for (const std::string& text : overrides) {
    apply(root, text, problems);
  }
}

}  // namespace percolith::case_file
