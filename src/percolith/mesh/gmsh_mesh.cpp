// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/gmsh_mesh.hpp"

#include "percolith/core/archive.hpp"
#include "percolith/core/hash.hpp"

namespace percolith::mesh {

static void describe_state(StateArchive& archive, GmshMesh& mesh) {
  archive.of_any_size("points", mesh.points);
  archive.of_any_size("triangles", mesh.triangles);
  archive.of_any_size("triangle_region", mesh.triangle_region);
  archive.of_any_size("regions", mesh.regions);
  for (auto& [name, edges] : mesh.curves) {
    archive.of_any_size("curve " + name, edges);
  }
  for (auto& [name, points] : mesh.point_groups) {
    archive.of_any_size("points " + name, points);
  }
}

std::string hash_of(const GmshMesh& mesh) {
  ByteHash hash;
  StateWriter writer([&](std::string_view bytes) { hash.add(bytes); });
  GmshMesh copy = mesh;  // a description may also be read into
  writer("mesh", copy);
  return hash.text();
}

}  // namespace percolith::mesh
