// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/mesh.hpp"
#include "percolith/simulation/setup.hpp"

#include <string>
#include <vector>

namespace percolith::simulation {

/// The curve a case names under option `key`. Throws InputError when the mesh has no such curve;
/// the message lists those it has and says when the name is a surface or a point instead.
[[nodiscard]] const mesh::CurveEdges& find_curve(const mesh::Mesh& mesh, const std::string& name,
                                                 const std::string& key);

/// The broken joints a fracture table asks for, ascending. Throws InputError when a curve is
/// unknown, lies on the boundary, or is not made of edges of the triangulation.
[[nodiscard]] std::vector<mesh::Index> fracture_joints(const mesh::Mesh& mesh,
                                                       const std::vector<std::string>& groups,
                                                       const std::string& key);

/// The boundary edges a boundary table asks for, ascending. Throws InputError when a curve is
/// unknown or runs inside the rock.
[[nodiscard]] std::vector<mesh::Index> boundary_edges(const mesh::Mesh& mesh,
                                                      const std::vector<std::string>& groups,
                                                      const std::string& key);

/// Numbers of the regions a case names under option `key`, in the order of the names. Throws
/// InputError for a name the mesh does not have.
[[nodiscard]] std::vector<mesh::Index>
find_regions(const mesh::Mesh& mesh, const std::vector<std::string>& names, const std::string& key);

/// Per region of the mesh the name of its material table. Throws InputError for unknown regions and
/// for regions with two materials or none.
[[nodiscard]] std::vector<std::string> material_of_regions(const Setup& setup,
                                                           const mesh::Mesh& mesh);

/// Names in quotes, separated by commas; "none" for an empty list.
[[nodiscard]] std::string quoted_list(const std::vector<std::string>& names);

/// `key[i]`, the option path of an entry of a list.
[[nodiscard]] std::string entry_key(const std::string& key, std::size_t i);

}  // namespace percolith::simulation
