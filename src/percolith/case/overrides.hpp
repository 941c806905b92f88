// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/node.hpp"
#include "percolith/case/problems.hpp"

#include <span>
#include <string>

namespace percolith::case_file {

/// Sets each `path.to.key=value` in `root`, in order. The value is TOML, or a bare text where it
/// is not valid TOML; an empty one takes the option out. Locations then name `--set`. What cannot
/// be set is added to `problems`.
void apply_overrides(Node& root, std::span<const std::string> overrides, Problems& problems);

/// Where overrides alone have made a table such as [material.NAME], which lacks required options,
/// and the file has one of nearly that name, one problem that names it takes the place of those of
/// the missing things. To be called once all problems are known.
void suggest_tables(const Node& root, Problems& problems);

}  // namespace percolith::case_file
