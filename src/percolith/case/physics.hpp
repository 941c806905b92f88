// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/node.hpp"
#include "percolith/case/problems.hpp"

#include <string_view>

namespace percolith::case_file {

/// The physics that a case asks for, known before its options are read: what `model.physics` says,
/// or "seepage" where it says nothing and all options are those of seepage. "" where it says
/// something else, which the reader reports, and where it is missing beside options that seepage
/// does not have: that is reported here, since it is not known then what the case is meant to be.
[[nodiscard]] std::string_view find_physics(const Node& root, Problems& problems);

}  // namespace percolith::case_file
