// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/gmsh_mesh.hpp"

#include <filesystem>
#include <string>

namespace percolith::mesh {

/// How a geometry is meshed.
struct GeoOptions {
  double element_size = 0.0;     ///< m; > 0: upper bound of the element size
  std::string program = "gmsh";  ///< name or path of Gmsh's program
};

/// Meshes a Gmsh geometry (`.geo`) by running the `gmsh` program, and reads the result; the
/// temporary mesh is deleted. The bound of the element size holds also when the geometry sets a
/// larger one, but not on curves whose divisions it prescribes (`Transfinite`). Throws FileError
/// when the geometry is missing or the program is not installed; InputError (key `mesh.file`) with
/// gmsh's own messages, file and line when it refuses the geometry, and as `read_gmsh` does.
[[nodiscard]] GmshMesh mesh_geo(const std::filesystem::path& path, const GeoOptions& options = {});

/// Reads a mesh (`.msh`) or meshes a geometry (`.geo`); a file with another extension is read when
/// its content is a Gmsh mesh. `element_size` in m, > 0: upper bound when a geometry is meshed; 0:
/// the geometry's own sizes. Throws as `read_gmsh` and `mesh_geo` do, and InputError for an
/// unknown kind of file or for a bound that a ready mesh cannot follow (key `mesh.element_size`).
[[nodiscard]] GmshMesh read_mesh(const std::filesystem::path& path, double element_size = 0.0);

}  // namespace percolith::mesh
