// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/gmsh_cursor.hpp"
#include "percolith/mesh/gmsh_mesh.hpp"
#include "percolith/mesh/gmsh_nodes.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace percolith::mesh {

/// What stands in a `.msh` file, before unused nodes are dropped and groups are named.
struct GmshContent {
  /// Names by dimension and number of the physical group.
  std::map<std::pair<int, int>, std::string> names;
  /// Physical groups by dimension and tag of the geometric entity (version 4 only).
  std::map<std::pair<int, int>, std::vector<int>> entity_groups;
  GmshNodes nodes;
  std::vector<std::array<std::int32_t, 3>> triangles;  ///< node indices
  std::vector<int> triangle_group;                     ///< number of the physical surface
  /// Node indices of edges and points by number of their physical group.
  std::map<int, std::vector<std::array<std::int32_t, 2>>> edges;
  std::map<int, std::vector<std::int32_t>> points;

  /// Name of a physical group; its number as text when the file gives none.
  [[nodiscard]] std::string group_name(int dimension, int number) const;
};

/// Dimension of the elements of a Gmsh type: 0 point, 1 edge, 2 triangle. Throws InputError at the
/// cursor for every other type, and says how to do without it.
[[nodiscard]] int element_dimension(int type, const GmshCursor& cursor);

/// Throws InputError at the cursor: triangles of a surface that is in no physical surface.
[[noreturn]] void fail_no_region(int surface, const GmshCursor& cursor);

/// Makes the mesh of a file's content: drops nodes of no triangle and the edges and points on
/// them, resolves the groups. Throws InputError when there are no triangles, when they do not lie
/// in a plane of constant z, or when an edge or point of a group lies inside a triangle.
[[nodiscard]] GmshMesh assemble_gmsh(const GmshContent& content, const std::string& file);

}  // namespace percolith::mesh
