// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/gmsh_checks.hpp"
#include "percolith/mesh/gmsh_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

namespace percolith::mesh {
namespace {

/// A triangle at an edge, filed under the edge's lower point.
struct EdgeSide {
  std::int32_t higher = 0;  ///< the edge's other point
  std::int32_t triangle = 0;
  friend bool operator<(const EdgeSide& a, const EdgeSide& b) {
    return a.higher != b.higher ? a.higher < b.higher : a.triangle < b.triangle;
  }
};

/// All edges of the triangles: for each point the sides of the edges of which it is the lower
/// point, sorted.
class EdgeTable {
public:
  explicit EdgeTable(const GmshMesh& mesh)
      : first_(mesh.points.size() + 1, 0), sides_(3 * mesh.triangles.size()) {
    for_each_edge(mesh, [&](std::int32_t lower, EdgeSide) { ++first_[at(lower) + 1]; });
    for (std::size_t i = 1; i < first_.size(); ++i) {
      first_[i] += first_[i - 1];
    }
    std::vector<std::int32_t> next(first_.begin(), first_.end() - 1);
    for_each_edge(mesh,
                  [&](std::int32_t lower, EdgeSide side) { sides_[at(next[at(lower)]++)] = side; });
    for (std::size_t i = 0; i + 1 < first_.size(); ++i) {
      std::sort(sides_.begin() + first_[i], sides_.begin() + first_[i + 1]);
    }
  }

  [[nodiscard]] std::span<const EdgeSide> sides(std::int32_t lower) const {
    const auto begin = first_[at(lower)];
    return std::span(sides_).subspan(at(begin), at(first_[at(lower) + 1] - begin));
  }

  [[nodiscard]] bool has_edge(std::int32_t a, std::int32_t b) const {
    const auto [lower, higher] = std::minmax(a, b);
    const std::span<const EdgeSide> all = sides(lower);
    const auto found = std::lower_bound(all.begin(), all.end(), EdgeSide{higher, 0});
    return found != all.end() && found->higher == higher;
  }

private:
  static std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }

  template <class Visit>
  static void for_each_edge(const GmshMesh& mesh, Visit visit) {
    std::int32_t triangle = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      visit(std::min(a, b), EdgeSide{std::max(a, b), triangle});
      visit(std::min(b, c), EdgeSide{std::max(b, c), triangle});
      visit(std::min(c, a), EdgeSide{std::max(c, a), triangle});
      ++triangle;
    }
  }

  std::vector<std::int32_t> first_;
  std::vector<EdgeSide> sides_;
};

const Point& point_of(const GmshMesh& mesh, std::int32_t index) {
  return mesh.points[static_cast<std::size_t>(index)];
}

Point middle(const GmshMesh& mesh, std::int32_t a, std::int32_t b) {
  return 0.5 * (point_of(mesh, a) + point_of(mesh, b));
}

std::int32_t opposite_point(const GmshMesh& mesh, std::int32_t triangle, std::int32_t a,
                            std::int32_t b) {
  for (const std::int32_t point : mesh.triangles[static_cast<std::size_t>(triangle)]) {
    if (point != a && point != b) {
      return point;
    }
  }
  return a;
}

[[noreturn]] void fail_twice(const GmshMesh& mesh, std::int32_t one, std::int32_t other) {
  const auto& [a, b, c] = mesh.triangles[static_cast<std::size_t>(one)];
  const Point centre = (1.0 / 3.0) * (point_of(mesh, a) + point_of(mesh, b) + point_of(mesh, c));
  const auto region = [&](std::int32_t triangle) {
    return mesh.triangle_region[static_cast<std::size_t>(triangle)];
  };
  if (region(one) != region(other)) {
    fail_mesh({mesh.file},
              fmt::format("region assigned twice: the triangle at {} is in the physical surfaces "
                          "'{}' and '{}'; keep one",
                          place_text(centre), mesh.regions[static_cast<std::size_t>(region(one))],
                          mesh.regions[static_cast<std::size_t>(region(other))]));
  }
  fail_mesh({mesh.file}, fmt::format("the triangle at {} is listed twice; surfaces must not "
                                     "overlap",
                                     place_text(centre)));
}

/// True when two different points lie on different sides of the line through an edge.
bool on_both_sides(const GmshMesh& mesh, std::int32_t a, std::int32_t b, std::int32_t one,
                   std::int32_t other) {
  const Point along = point_of(mesh, b) - point_of(mesh, a);
  const double left = cross(along, point_of(mesh, one) - point_of(mesh, a));
  const double right = cross(along, point_of(mesh, other) - point_of(mesh, a));
  return (left > 0.0) != (right > 0.0);
}

/// Says what is wrong with the triangles at the edge from `lower` to the sides' `higher` point.
[[noreturn]] void fail_edge(const GmshMesh& mesh, std::int32_t lower,
                            std::span<const EdgeSide> sides) {
  const std::int32_t higher = sides.front().higher;
  std::vector<std::pair<std::int32_t, std::int32_t>> opposite;
  for (const EdgeSide& side : sides) {
    opposite.emplace_back(opposite_point(mesh, side.triangle, lower, higher), side.triangle);
  }
  std::sort(opposite.begin(), opposite.end());
  for (std::size_t i = 1; i < opposite.size(); ++i) {
    if (opposite[i].first == opposite[i - 1].first) {
      fail_twice(mesh, opposite[i - 1].second, opposite[i].second);
    }
  }
  const std::string place = place_text(middle(mesh, lower, higher));
  if (sides.size() > 2) {
    fail_mesh({mesh.file},
              fmt::format("the edge at {} belongs to {} triangles; surfaces must not overlap",
                          place, sides.size()),
              "one or two triangles at an edge");
  }
  fail_mesh({mesh.file},
            fmt::format("the two triangles at the edge at {} lie on the same side of it: one is "
                        "inverted (folded over); mend the geometry there or mesh finer",
                        place));
}

/// Checks an edge of two or more triangles.
void check_edge(const GmshMesh& mesh, std::int32_t lower, std::span<const EdgeSide> sides) {
  const std::int32_t higher = sides[0].higher;
  const std::int32_t one = opposite_point(mesh, sides[0].triangle, lower, higher);
  const std::int32_t other = opposite_point(mesh, sides[1].triangle, lower, higher);
  if (sides.size() > 2 || !on_both_sides(mesh, lower, higher, one, other)) {
    fail_edge(mesh, lower, sides);
  }
}

void check_sides(const GmshMesh& mesh, const EdgeTable& edges) {
  const auto points = static_cast<std::int32_t>(mesh.points.size());
  for (std::int32_t lower = 0; lower < points; ++lower) {
    const std::span<const EdgeSide> all = edges.sides(lower);
    for (std::size_t begin = 0; begin < all.size();) {
      std::size_t end = begin + 1;
      while (end < all.size() && all[end].higher == all[begin].higher) {
        ++end;
      }
      if (end - begin > 1) {
        check_edge(mesh, lower, all.subspan(begin, end - begin));
      }
      begin = end;
    }
  }
}

}  // namespace

void check_gmsh_edges(const GmshMesh& mesh) {
  const EdgeTable edges(mesh);
  check_sides(mesh, edges);
  for (const auto& [name, curve] : mesh.curves) {
    for (const auto& [a, b] : curve) {
      if (!edges.has_edge(a, b)) {
        fail_mesh({mesh.file},
                  fmt::format("an edge of physical curve '{}' at {} is not an edge of a triangle; "
                              "embed the curve with 'Curve{{...}} In Surface{{...}};' and mesh "
                              "again",
                              name, place_text(middle(mesh, a, b))));
      }
    }
  }
}

}  // namespace percolith::mesh
