// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/gmsh_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace percolith::mesh {

void fail_mesh(const FileLocation& location, const std::string& reason,
               const std::string& allowed) {
  throw InputError({location, "mesh.file", "", reason, allowed});
}

std::string place_text(const Point& place) {
  return fmt::format("({:.9g}, {:.9g})", place.x, place.y);
}

std::string printable_text(std::string_view text) {
  constexpr std::size_t longest = 32;
  std::string result(text.substr(0, longest));
  std::replace_if(
      result.begin(), result.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text.size() > longest ? result + "..." : result;
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
