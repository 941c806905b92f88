// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/toml_parser.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <regex>
#include <string>

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

/// What helps where a letter follows a number: the commonest slip is a unit without quotes.
std::string hint_of(std::string_view text, const toml::source_position& place) {
  std::size_t start = 0;
  for (toml::source_index line = 1; line < place.line && start != std::string_view::npos; ++line) {
    const std::size_t end = text.find('\n', start);
    start = end == std::string_view::npos ? end : end + 1;
  }
  if (start == std::string_view::npos) {
    return {};
  }
  const std::string line(text.substr(start, text.find_first_of("\r\n", start) - start));
  static const std::regex bare(
      R"(=\s*([-+]?[0-9][0-9.eE+-]*\s*[A-Za-z%][A-Za-z0-9/^ ]*?)\s*(#.*)?$)");
  std::smatch found;
  return std::regex_search(line, found, bare)
             ? fmt::format("a value with a unit in quotes: \"{}\"", found[1].str())
             : std::string();
}

}  // namespace

Node parse_toml(std::string_view text, const std::string& file) {
  try {
    const toml::table table = toml::parse(text, std::string_view(file));
    return convert(table, file);
  } catch (const toml::parse_error& error) {
    throw InputError(InputProblem{location_of(error.source(), file),
                                  {},
                                  {},
                                  reason_of(error),
                                  hint_of(text, error.source().begin)});
  }
}

}  // namespace percolith::case_file
