// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/seepage/model.hpp"

#include <optional>
#include <string>

namespace percolith::simulation {

/// A warning where steady flow is sure to need suction: no head in it exceeds the highest one that
/// a condition gives, unless a source or flux lets fluid in, and rock that reaches above that head
/// would drain. Absent where nothing can be told beforehand.
[[nodiscard]] std::optional<std::string> steady_suction_warning(const seepage::Model& model);

}  // namespace percolith::simulation
