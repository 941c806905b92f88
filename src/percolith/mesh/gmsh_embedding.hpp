// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/vec2.hpp"
#include "percolith/mesh/gmsh_mesh.hpp"

#include <string>
#include <vector>

namespace percolith::mesh {

/// A point of a physical group, or the middle of an edge of one, that is no part of the
/// triangulation.
struct LoosePlace {
  Point place;  ///< m
  std::string group;
  int dimension = 0;  ///< of the group: 0 points, 1 curves
};

/// Throws InputError when a loose place lies in a triangle: then the curve or point was meant to
/// be in the mesh but was not embedded in its surface. Loose places outside all triangles pass:
/// they are, for instance, the ends of fractures that stick out of the model. The cost grows with
/// the triangles times the loose places that lie in their range of x.
void check_embedding(const GmshMesh& mesh, std::vector<LoosePlace> loose);

}  // namespace percolith::mesh
