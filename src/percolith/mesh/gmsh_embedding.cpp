// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/gmsh_embedding.hpp"

#include "percolith/mesh/gmsh_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace percolith::mesh {
namespace {

struct Corners {
  Point a, b, c;
};

/// True when `p` lies in the triangle or on its border, rounding allowed for.
bool contains(const Corners& t, const Point& p) {
  const double area = cross(t.b - t.a, t.c - t.a);
  const double tolerance = -1e-9 * std::abs(area);
  const double sign = area < 0.0 ? -1.0 : 1.0;
  return sign * cross(t.b - t.a, p - t.a) >= tolerance &&
         sign * cross(t.c - t.b, p - t.b) >= tolerance &&
         sign * cross(t.a - t.c, p - t.c) >= tolerance;
}

[[noreturn]] void fail_loose(const GmshMesh& mesh, const LoosePlace& loose) {
  if (loose.dimension == 1) {
    fail_mesh({mesh.file},
              fmt::format("physical curve '{}' runs through the mesh at {} without being part of "
                          "it; embed it with 'Curve{{...}} In Surface{{...}};', or by "
                          "'BooleanFragments', and mesh again",
                          loose.group, place_text(loose.place)));
  }
  fail_mesh({mesh.file},
            fmt::format("physical point '{}' at {} lies in the mesh without being part of it; "
                        "embed it with 'Point{{...}} In Surface{{...}};' and mesh again",
                        loose.group, place_text(loose.place)));
}

}  // namespace

void check_embedding(const GmshMesh& mesh, std::vector<LoosePlace> loose) {
  if (loose.empty()) {
    return;
  }
  std::sort(loose.begin(), loose.end(),
            [](const LoosePlace& a, const LoosePlace& b) { return a.place.x < b.place.x; });
  for (const auto& triangle : mesh.triangles) {
    const Corners t{mesh.points[static_cast<std::size_t>(triangle[0])],
                    mesh.points[static_cast<std::size_t>(triangle[1])],
                    mesh.points[static_cast<std::size_t>(triangle[2])]};
    const double left = std::min({t.a.x, t.b.x, t.c.x});
    const double right = std::max({t.a.x, t.b.x, t.c.x});
    auto next = std::lower_bound(loose.begin(), loose.end(), left,
                                 [](const LoosePlace& a, double x) { return a.place.x < x; });
    for (; next != loose.end() && next->place.x <= right; ++next) {
      if (contains(t, next->place)) {
        fail_loose(mesh, *next);
      }
    }
  }
}

}  // namespace percolith::mesh
