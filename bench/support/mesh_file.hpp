// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/gmsh_mesh.hpp"

#include <string>

namespace percolith::bench {

/// The content of a binary Gmsh file, version 2.2, with the triangles and curves of a mesh.
[[nodiscard]] std::string mesh_file(const mesh::GmshMesh& mesh);

}  // namespace percolith::bench
