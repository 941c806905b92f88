// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/toml_parser.hpp"

#include <toml++/toml.h>

// The only file that sees toml++, which is slow to compile.
namespace percolith::case_file {

namespace {

FileLocation location_of(const toml::source_region& source, const std::string& file) {
  return {file, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

Node convert(const toml::node& source, const std::string& file) {
  Node node;
  node.location = location_of(source.source(), file);
  node.key_location = node.location;
  if (const toml::table* table = source.as_table()) {
    Entries entries;
    for (const auto& [key, value] : *table) {
      Node& entry = entries.set(std::string(key.str()), convert(value, file));
      entry.key_location = location_of(key.source(), file);
    }
    node.value = std::move(entries);
  } else if (const toml::array* array = source.as_array()) {
    Array list;
    for (const toml::node& value : *array) {
      list.push_back(convert(value, file));
    }
    node.value = std::move(list);
  } else if (const auto* text = source.as_string()) {
    node.value = text->get();
  } else if (const auto* number = source.as_floating_point()) {
    node.value = number->get();
  } else if (const auto* whole = source.as_integer()) {
    node.value = whole->get();
  } else if (const auto* flag = source.as_boolean()) {
    node.value = flag->get();
  } else {
    node.value = Date{};
  }
  return node;
}

/// What toml++ says, without its account of what it was doing.
std::string reason_of(const toml::parse_error& error) {
  std::string text(error.description());
  if (text.rfind("Error while parsing ", 0) == 0) {
    const std::size_t colon = text.find(": ");
    if (colon != std::string::npos) {
      text.erase(0, colon + 2);
    }
  }
  return "not valid TOML: " + text;
}

}  // namespace

Node parse_toml(std::string_view text, const std::string& file) {
  try {
    const toml::table table = toml::parse(text, std::string_view(file));
    return convert(table, file);
  } catch (const toml::parse_error& error) {
    throw InputError(InputProblem{location_of(error.source(), file), {}, {}, reason_of(error), {}});
  }
}

}  // namespace percolith::case_file
