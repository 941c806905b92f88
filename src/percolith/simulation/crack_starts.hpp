// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/mesh.hpp"
#include "percolith/simulation/setup.hpp"

#include <string>
#include <vector>

namespace percolith::simulation {

/// A vertex at which cracks are likely to start, and what is there, in words.
struct CrackStart {
  mesh::Index vertex = 0;
  std::string what;  ///< "the end of fracture.notch"
};

/// Where cracks are likely to start: the ends of open fractures inside the rock, sources,
/// boundaries that fluid presses with more than it does at the start, walls of excavations and of
/// holes, and all of a cohesive fracture that none of these touches. Ascending in vertices, each
/// once. Throws InputError for groups that the mesh does not have.
[[nodiscard]] std::vector<CrackStart> crack_starts(const Setup& setup, const mesh::Mesh& mesh);

/// Vertices on the inner boundaries of the rock: those that run clockwise round a hole.
[[nodiscard]] std::vector<mesh::Index> hole_vertices(const mesh::Mesh& mesh);

}  // namespace percolith::simulation
