// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/gmsh_content.hpp"

#include <fmt/format.h>

namespace percolith::mesh {
namespace {

constexpr const char* allowed_elements = "triangles of 3 nodes, lines of 2 nodes, points";

[[noreturn]] void fail_solid(const char* name, const GmshCursor& cursor) {
  cursor.fail(fmt::format("the mesh holds {}; a two-dimensional mesh is needed: mesh with "
                          "'gmsh -2' and leave physical volumes out",
                          name),
              allowed_elements);
}

[[noreturn]] void fail_quadrangle(const char* name, const GmshCursor& cursor) {
  cursor.fail(fmt::format("the mesh holds {}; leave out 'Recombine' and "
                          "'Mesh.RecombineAll', and mesh again",
                          name),
              allowed_elements);
}

[[noreturn]] void fail_order(const char* name, const GmshCursor& cursor) {
  cursor.fail(fmt::format("the mesh holds {}; set 'Mesh.ElementOrder = 1' and mesh again", name),
              allowed_elements);
}

}  // namespace

int element_dimension(int type, const GmshCursor& cursor) {
  switch (type) {
  case 15:
    return 0;
  case 1:
    return 1;
  case 2:
    return 2;
  case 3:
    fail_quadrangle("quadrangles", cursor);
  case 4:
    fail_solid("tetrahedra", cursor);
  case 5:
    fail_solid("hexahedra", cursor);
  case 6:
    fail_solid("prisms", cursor);
  case 7:
    fail_solid("pyramids", cursor);
  case 8:
    fail_order("quadratic lines (3 nodes)", cursor);
  case 9:
    fail_order("quadratic triangles (6 nodes)", cursor);
  case 10:
    fail_quadrangle("quadratic quadrangles (9 nodes)", cursor);
  case 11:
    fail_solid("quadratic tetrahedra (10 nodes)", cursor);
  case 16:
    fail_quadrangle("quadratic quadrangles (8 nodes)", cursor);
  case 20:
  case 21:
    fail_order("cubic triangles", cursor);
  case 26:
    fail_order("cubic lines (4 nodes)", cursor);
  default:
    cursor.fail(fmt::format("the mesh holds elements of Gmsh type {}", type), allowed_elements);
  }
}

void fail_no_region(int surface, const GmshCursor& cursor) {
  cursor.fail(fmt::format("triangles of surface {0} are in no physical surface, so they have no "
                          "material; add 'Physical Surface(\"rock\") = {{{0}}};' to the geometry "
                          "and mesh again",
                          surface));
}

std::string GmshContent::group_name(int dimension, int number) const {
  const auto found = names.find({dimension, number});
  return found != names.end() ? found->second : std::to_string(number);
}

}  // namespace percolith::mesh
