// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/error.hpp"
#include "percolith/mesh/mesh.hpp"
#include "percolith/mesh/ordering.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace percolith::mesh {
namespace {

/// A directed edge of a triangle: local corner k to k + 1.
struct Side {
  std::uint64_t key;  // both vertices, the smaller one first
  Index triangle;
  Index k;
};

std::uint64_t edge_key(Index a, Index b) {
  const auto low = static_cast<std::uint64_t>(std::min(a, b));
  const auto high = static_cast<std::uint64_t>(std::max(a, b));
  return low << 32U | high;
}

/// Triangles in the order of the space-filling curve, counter-clockwise, in file vertex numbers.
void order_triangles(const GmshMesh& file, Mesh& mesh) {
  std::vector<Point> centre(file.triangles.size());
  for (std::size_t t = 0; t < centre.size(); ++t) {
    const auto& [a, b, c] = file.triangles[t];
    centre[t] = (1.0 / 3.0) * (file.points[at(a)] + file.points[at(b)] + file.points[at(c)]);
  }
  mesh.triangle_vertex.reserve(centre.size());
  mesh.region.reserve(centre.size());
  for (const Index t : hilbert_order(centre)) {
    std::array<Index, 3> v = file.triangles[at(t)];
    const Point origin = file.points[at(v[0])];
    if (cross(file.points[at(v[1])] - origin, file.points[at(v[2])] - origin) < 0.0) {
      std::swap(v[1], v[2]);
    }
    mesh.triangle_vertex.push_back(v);
    mesh.region.push_back(file.triangle_region[at(t)]);
  }
}

/// Numbers the vertices in the order in which the triangles meet them; returns file -> mesh.
std::vector<Index> number_vertices(const GmshMesh& file, Mesh& mesh) {
  std::vector<Index> number(file.points.size(), none);
  mesh.vertex.reserve(file.points.size());
  for (auto& triangle : mesh.triangle_vertex) {
    for (Index& v : triangle) {
      if (number[at(v)] == none) {
        number[at(v)] = mesh.vertices();
        mesh.vertex.push_back(file.points[at(v)]);
      }
      v = number[at(v)];
    }
  }
  return number;
}

std::vector<Side> sorted_sides(const Mesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangle_vertex.size());
  for (Index t = 0; t < mesh.triangles(); ++t) {
    const auto& v = mesh.triangle_vertex[at(t)];
    for (Index k = 0; k < 3; ++k) {
      sides.push_back({edge_key(v[at(k)], v[at((k + 1) % 3)]), t, k});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::pair(a.key, a.triangle) < std::pair(b.key, b.triangle);
  });
  return sides;
}

Joint joint_between(const Mesh& mesh, const Side& first, const Side& second) {
  const auto& v = mesh.triangle_vertex[at(first.triangle)];
  const Index next_first = (first.k + 1) % 3;
  const Index next_second = (second.k + 1) % 3;
  // The second triangle walks the edge the other way round.
  return {{v[at(first.k)], v[at(next_first)]},
          {{{corner_of(first.triangle, first.k), corner_of(first.triangle, next_first)},
            {corner_of(second.triangle, next_second), corner_of(second.triangle, second.k)}}}};
}

[[noreturn]] void refuse_shared_edge(const GmshMesh& file, const Mesh& mesh, Index vertex) {
  const Point p = mesh.vertex[at(vertex)];
  throw InputError(
      {{file.file, 0, 0},
       "mesh.file",
       "",
       fmt::format("an edge at ({:g}, {:g}) belongs to more than two triangles", p.x, p.y),
       "a conforming triangulation of the plane"});
}

/// Joints and boundary edges, numbered in the order of their first triangle.
void connect(const GmshMesh& file, Mesh& mesh) {
  const std::vector<Side> sides = sorted_sides(mesh);
  std::vector<std::pair<Side, Side>> pairs;
  std::vector<Side> single;
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].key == sides[i].key) {
      ++end;
    }
    if (end - i > 2) {
      refuse_shared_edge(file, mesh, static_cast<Index>(sides[i].key >> 32U));
    }
    if (end - i == 2) {
      pairs.emplace_back(sides[i], sides[i + 1]);
    } else {
      single.push_back(sides[i]);
    }
    i = end;
  }
  const auto before = [](const Side& a, const Side& b) {
    return std::pair(a.triangle, a.k) < std::pair(b.triangle, b.k);
  };
  std::sort(pairs.begin(), pairs.end(),
            [&](const auto& a, const auto& b) { return before(a.first, b.first); });
  std::sort(single.begin(), single.end(), before);
  mesh.joint.reserve(pairs.size());
  for (const auto& [first, second] : pairs) {
    mesh.joint.push_back(joint_between(mesh, first, second));
  }
  for (const Side& side : single) {
    const auto& v = mesh.triangle_vertex[at(side.triangle)];
    const Index next = (side.k + 1) % 3;
    mesh.boundary.push_back({{v[at(side.k)], v[at(next)]},
                             {corner_of(side.triangle, side.k), corner_of(side.triangle, next)}});
  }
}

/// Table of the items that name a row, ascending in each row because items come in that order.
template <class Visit>
IndexTable tabulate(Index rows, const Visit& visit) {
  IndexTable table;
  table.start.assign(at(rows) + 1, 0);
  visit([&](Index row, Index) { ++table.start[at(row) + 1]; });
  for (std::size_t r = 0; r < at(rows); ++r) {
    table.start[r + 1] += table.start[r];
  }
  table.entry.resize(at(table.start.back()));
  std::vector<Index> next(table.start.begin(), table.start.end() - 1);
  visit([&](Index row, Index item) { table.entry[at(next[at(row)]++)] = item; });
  return table;
}

void tabulate_vertices(Mesh& mesh) {
  mesh.vertex_corners = tabulate(mesh.vertices(), [&](const auto& add) {
    for (Index c = 0; c < mesh.corners(); ++c) {
      if (triangle_of(c) < mesh.triangles()) {
        add(mesh.vertex_of(c), c);
      }
    }
  });
  mesh.vertex_joints = tabulate(mesh.vertices(), [&](const auto& add) {
    for (Index j = 0; j < mesh.joints(); ++j) {
      add(mesh.joint[at(j)].vertex[0], j);
      add(mesh.joint[at(j)].vertex[1], j);
    }
  });
}

/// Finds edges by their two vertices.
class EdgeFinder {
public:
  explicit EdgeFinder(const Mesh& mesh) {
    for (Index j = 0; j < mesh.joints(); ++j) {
      const auto& v = mesh.joint[at(j)].vertex;
      entry_.push_back({edge_key(v[0], v[1]), j});
    }
    for (std::size_t b = 0; b < mesh.boundary.size(); ++b) {
      const auto& v = mesh.boundary[b].vertex;
      entry_.push_back({edge_key(v[0], v[1]), -1 - static_cast<Index>(b)});
    }
    std::sort(entry_.begin(), entry_.end());
  }
  /// Joint number, or -1 - number of a boundary edge; false when there is no such edge.
  bool find(Index a, Index b, Index& found) const {
    const auto key = edge_key(a, b);
    const auto it = std::lower_bound(entry_.begin(), entry_.end(), std::pair(key, Index{-1 << 30}));
    if (it == entry_.end() || it->first != key) {
      return false;
    }
    found = it->second;
    return true;
  }

private:
  std::vector<std::pair<std::uint64_t, Index>> entry_;
};

void sort_unique(std::vector<Index>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

void resolve_groups(const GmshMesh& file, const std::vector<Index>& number, Mesh& mesh) {
  if (!file.curves.empty()) {
    const EdgeFinder finder(mesh);
    for (const auto& [name, edges] : file.curves) {
      CurveEdges& curve = mesh.curves[name];
      for (const auto& edge : edges) {
        const Index a = number[at(edge[0])];
        const Index b = number[at(edge[1])];
        Index found = 0;
        if (a == none || b == none || !finder.find(a, b, found)) {
          curve.loose.push_back(edge);
        } else if (found >= 0) {
          curve.joints.push_back(found);
        } else {
          curve.boundary.push_back(-1 - found);
        }
      }
      sort_unique(curve.joints);
      sort_unique(curve.boundary);
    }
  }
  for (const auto& [name, points] : file.point_groups) {
    auto& group = mesh.point_groups[name];
    for (const Index p : points) {
      if (number[at(p)] != none) {
        group.push_back(number[at(p)]);
      }
    }
    sort_unique(group);
  }
}

}  // namespace

Mesh build_mesh(const GmshMesh& file) {
  Mesh mesh;
  mesh.region_names = file.regions;
  order_triangles(file, mesh);
  const std::vector<Index> number = number_vertices(file, mesh);
  connect(file, mesh);
  tabulate_vertices(mesh);
  resolve_groups(file, number, mesh);
  return mesh;
}

}  // namespace percolith::mesh
