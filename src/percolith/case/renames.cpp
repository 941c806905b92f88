// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/renames.hpp"

#include "percolith/case/key_locations.hpp"
#include "percolith/case/path.hpp"

#include <fmt/format.h>

#include <array>
#include <functional>

namespace percolith::case_file {

namespace {

/// Format 1 is the first, so no option has been renamed in it yet.
const std::array<Rename, 0> renamed{};

std::string dotted(const Path& path) {
  std::string text;
  for (const std::string& part : path) {
    text += text.empty() ? "" : ".";
    text += part;
  }
  return text;
}

/// All paths in `node` that match `pattern` from its part `depth` on.
void match(const Node& node, const Path& pattern, Path& so_far, std::vector<Path>& found) {
  if (so_far.size() == pattern.size()) {
    found.push_back(so_far);
    return;
  }
  if (node.table() == nullptr) {
    return;
  }
  const std::string& part = pattern[so_far.size()];
  for (const Entry& entry : node.table()->list) {
    if (part == "*" || part == entry.key) {
      so_far.push_back(entry.key);
      match(entry.value, pattern, so_far, found);
      so_far.pop_back();
    }
  }
}

/// `to` with its stars replaced by what stood for those of `from` in `path`.
Path new_path(const Path& path, const Path& from, Path to) {
  std::size_t star = 0;
  for (std::string& part : to) {
    if (part == "*") {
      while (from[star] != "*") {
        ++star;
      }
      part = path[star++];
    }
  }
  return to;
}

/// Takes out the value and the tables that held nothing else.
void erase_with_empty_tables(Node& root, Path path) {
  erase_at(root, path);
  for (path.pop_back(); !path.empty(); path.pop_back()) {
    const Node* table = find_at(root, path);
    if (table == nullptr || table->table() == nullptr || !table->table()->list.empty()) {
      return;
    }
    erase_at(root, path);
  }
}

}  // namespace

std::span<const Rename> renamed_options() {
  return renamed;
}

std::vector<std::string> apply_renames(Node& root, std::span<const Rename> renames,
                                       Problems& problems) {
  std::vector<std::string> warnings;
  for (const Rename& rename : renames) {
    const Path from = split_path(rename.from);
    const Path to = split_path(rename.to);
    std::vector<Path> found;
    Path so_far;
    match(root, from, so_far, found);
    for (const Path& path : found) {
      const Path target = new_path(path, from, to);
      Node value = *find_at(root, path);
      if (find_at(root, target) != nullptr) {
        problems.add({value.key_location, dotted(path), case_file::to_text(value),
                      fmt::format("given twice: it is the old name of {}", dotted(target)),
                      dotted(target)});
      } else if (first_non_table(root, target).empty()) {
        warnings.push_back(fmt::format(
            "{}: warning: {} is now called {}; the old name is understood until version {}",
            to_text(value.key_location), dotted(path), dotted(target), rename.removed_in));
        set_at(root, target, std::move(value));
      }
      erase_with_empty_tables(root, path);
    }
  }
  return warnings;
}

}  // namespace percolith::case_file
