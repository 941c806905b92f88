// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/gmsh_problem.hpp"

#include <fmt/format.h>

#include <limits>

namespace percolith::mesh {

void fail_mesh(const FileLocation& location, const std::string& reason,
               const std::string& allowed) {
  throw InputError({location, "mesh.file", "", reason, allowed});
}

std::string place_text(const Point& place) {
  return fmt::format("({:.9g}, {:.9g})", place.x, place.y);
}

void require_countable(std::uint64_t count, std::string_view what, const FileLocation& location) {
  constexpr std::uint64_t most = std::numeric_limits<std::int32_t>::max() / 3;
  if (count > most) {
    fail_mesh(location,
              fmt::format("the mesh has {} {}, more than 32-bit indices can number; mesh coarser",
                          count, what),
              fmt::format("at most {} {}", most, what));
  }
}

}  // namespace percolith::mesh
