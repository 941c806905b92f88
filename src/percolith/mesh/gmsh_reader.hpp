// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/gmsh_mesh.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace percolith::mesh {

/// Reads a Gmsh mesh file: `.msh` 2.2 or 4.1, text or binary, in either byte order. Groups without
/// a name get their number as name; groups that the file names but that hold no edge or point of
/// the triangles are there, empty. The mesh has passed `check_gmsh_mesh`. Throws FileError when the
/// file is missing or unreadable, InputError (key `mesh.file`; line in a text file, byte offset in
/// the reason for a binary one) when its content cannot be used.
[[nodiscard]] GmshMesh read_gmsh(const std::filesystem::path& path);

/// The same for a file's content in memory; `file` is its name in messages.
[[nodiscard]] GmshMesh read_gmsh(std::string_view content, const std::string& file);

/// True when `content` begins as a `.msh` file does.
[[nodiscard]] bool looks_like_gmsh(std::string_view content);

}  // namespace percolith::mesh
