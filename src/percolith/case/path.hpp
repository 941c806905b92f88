// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/node.hpp"

#include <string>
#include <string_view>
#include <vector>

// Dotted paths into a parsed document.
namespace percolith::case_file {

using Path = std::vector<std::string>;

/// The parts of a dotted path.
[[nodiscard]] Path split_path(std::string_view text);
/// True for a name of the letters A to Z and a to z, digits, _ and -, at least one.
[[nodiscard]] bool is_plain_name(std::string_view name);
/// True where every part is a plain name.
[[nodiscard]] bool is_plain_path(const Path& path);
/// The text without blanks at its ends.
[[nodiscard]] std::string trimmed(std::string_view text);

/// The value at `path`, or null.
[[nodiscard]] const Node* find_at(const Node& root, const Path& path);
/// The first part of `path`, dotted, that stands in `root`, would have to be a table and is none;
/// "" where there is no such part.
[[nodiscard]] std::string first_non_table(const Node& root, const Path& path);
/// Puts the value at `path`, adding the tables on the way, at the value's location. All that stands
/// on the way must be tables.
void set_at(Node& root, const Path& path, Node value);
/// Takes out the value at `path` where there is one.
void erase_at(Node& root, const Path& path);

}  // namespace percolith::case_file
