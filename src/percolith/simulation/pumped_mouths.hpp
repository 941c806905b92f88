// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/mesh.hpp"
#include "percolith/simulation/setup.hpp"

#include <string>
#include <vector>

namespace percolith::simulation {

/// Warnings of fractures that a source pumps into and that end on a boundary with a
/// `normal_pressure`: the fluid in the opening does not share the pressure of the fracture, which
/// pushes the rock between both into the opening. One for each boundary and fracture of a source.
[[nodiscard]] std::vector<std::string> pumped_mouth_warnings(const Setup& setup,
                                                             const mesh::Mesh& mesh);

}  // namespace percolith::simulation
