// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/node.hpp"
#include "percolith/case/problems.hpp"

#include <span>
#include <string>
#include <vector>

namespace percolith::case_file {

/// An option that was given a new path. A `*` stands for any name the user chose; both paths have
/// their stars in the same order. The old path is understood until version `removed_in`.
struct Rename {
  std::string from;
  std::string to;
  std::string removed_in;
};

/// The options renamed in this version or the one before.
[[nodiscard]] std::span<const Rename> renamed_options();

/// Moves every renamed option in `root` to its new path and returns a warning for each. An option
/// given by both names is added to `problems`.
[[nodiscard]] std::vector<std::string> apply_renames(Node& root, std::span<const Rename> renames,
                                                     Problems& problems);

}  // namespace percolith::case_file
