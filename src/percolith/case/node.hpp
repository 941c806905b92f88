// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/error.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

// A parsed TOML document as plain values with their places in the file.
namespace percolith::case_file {

struct Node;
struct Entry;

using Array = std::vector<Node>;

/// Keys and values, sorted by key.
struct Entries {
  std::vector<Entry> list;

  [[nodiscard]] Node* find(std::string_view key);
  [[nodiscard]] const Node* find(std::string_view key) const;
  /// Adds the entry, or replaces the one of the same key.
  Node& set(std::string key, Node value);
  /// Takes the entry out where there is one.
  void erase(std::string_view key);
};

/// A date or time of day, for which the case file has no use.
struct Date {};

/// A value and where it stands.
struct Node {
  std::variant<bool, std::int64_t, double, std::string, Date, Array, Entries> value;
  FileLocation location;      ///< of the value
  FileLocation key_location;  ///< of its key

  [[nodiscard]] const Entries* table() const { return std::get_if<Entries>(&value); }
  [[nodiscard]] Entries* table() { return std::get_if<Entries>(&value); }
  [[nodiscard]] const Array* array() const { return std::get_if<Array>(&value); }
  [[nodiscard]] const std::string* text() const { return std::get_if<std::string>(&value); }
};

struct Entry {
  std::string key;
  Node value;
};

/// The value as it would be written in one line, shortened to about 60 characters.
[[nodiscard]] std::string to_text(const Node& node);

/// What kind of value it is: "a number", "a text", "a list", ...
[[nodiscard]] std::string kind_of(const Node& node);

/// A number as TOML, with the fewest digits that give the same double again; always a float.
[[nodiscard]] std::string to_toml(double value);

/// A text as a TOML basic string with its quotes.
[[nodiscard]] std::string to_toml(std::string_view text);

}  // namespace percolith::case_file
