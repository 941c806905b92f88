// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/model.hpp"

#include <span>
#include <string>
#include <vector>

namespace percolith::simulation {

/// Warnings of stress at time zero that bonded joints do not bear: the effective traction that the
/// in-situ stress and the initial pressure give them against tensile strength f_t and shear
/// strength c + max(0, -t_n) tan phi (theory.md section 10, M6). One for each material and cohesive
/// fracture with such joints; `names` are those of their tables, in the order of
/// `mechanics::JointKind::owner`.
[[nodiscard]] std::vector<std::string> start_strength_warnings(const mechanics::Model& model,
                                                               std::span<const std::string> names);

}  // namespace percolith::simulation
