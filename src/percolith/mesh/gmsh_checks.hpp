// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/gmsh_mesh.hpp"

namespace percolith::mesh {

/// Throws InputError (key `mesh.file`, with the place) unless the mesh can carry a model: indices
/// in range; finite coordinates; triangles with an area, none listed twice or in two regions; two
/// triangles at most on an edge, one on each side; no two points at one place (closer than 1e-8 of
/// the mesh's extent); every edge of a physical curve an edge of a triangle. Whether triangles are
/// listed clockwise does not matter. Linear in the size of the mesh.
void check_gmsh_mesh(const GmshMesh& mesh);

/// The parts of `check_gmsh_mesh`, in the order in which it runs them; each relies on those before.
void check_gmsh_indices(const GmshMesh& mesh);
void check_gmsh_coordinates(const GmshMesh& mesh);
void check_gmsh_areas(const GmshMesh& mesh);
void check_gmsh_duplicate_points(const GmshMesh& mesh);
void check_gmsh_edges(const GmshMesh& mesh);

}  // namespace percolith::mesh
