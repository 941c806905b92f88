// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/error.hpp"
#include "percolith/mesh/gmsh_checks.hpp"
#include "percolith/mesh/gmsh_reader.hpp"

#include <cstdint>
#include <cstdlib>
#include <string_view>

// Whatever bytes a mesh file holds, reading it ends in a sound mesh or in an error for the user.
// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view content(reinterpret_cast<const char*>(bytes), size);
  try {
    const percolith::mesh::GmshMesh mesh = percolith::mesh::read_gmsh(content, "fuzz.msh");
    if (mesh.triangles.empty() || mesh.points.size() > size) {
      std::abort();
    }
    percolith::mesh::check_gmsh_mesh(mesh);
  } catch (const percolith::Error&) {
    return 0;
  }
  return 0;
}
