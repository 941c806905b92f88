// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/gmsh_program.hpp"

#include <filesystem>

namespace percolith::mesh {

/// Throws InputError (key `mesh.file`) when gmsh failed or printed errors, whatever its exit code:
/// after an error it may go on and write a mesh with holes. The location is the file and line that
/// the first error names, else `geometry`; the reason quotes gmsh's own lines.
void throw_geo_errors(const ProgramResult& result, const std::filesystem::path& geometry);

}  // namespace percolith::mesh
