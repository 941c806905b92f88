// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/gmsh_cursor.hpp"

namespace percolith::mesh {

enum class GmshVersion { v22, v41 };

/// Reads a `.msh` file up to and including `$EndMeshFormat` and switches the cursor to binary
/// where the file is. Throws InputError at the cursor for a file that is not Gmsh's (it names what
/// it looks like) and for a version or a number size that is not supported.
[[nodiscard]] GmshVersion read_gmsh_header(GmshCursor& cursor);

}  // namespace percolith::mesh
