// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/overrides.hpp"

#include "percolith/case/path.hpp"
#include "percolith/case/toml_parser.hpp"

#include <algorithm>
#include <string_view>

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

}  // namespace

void apply_overrides(Node& root, std::span<const std::string> overrides, Problems& problems) {
  for (const std::string& text : overrides) {
    apply(root, text, problems);
  }
}

}  // namespace percolith::case_file
