// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/gmsh_content.hpp"
#include "percolith/mesh/gmsh_embedding.hpp"
#include "percolith/mesh/gmsh_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace percolith::mesh {
namespace {

constexpr std::int32_t unused = -1;

Point plane_place(const GmshContent& content, std::int32_t node) {
  const std::array<double, 3>& place = content.nodes.place(node);
  return {place[0], place[1]};
}

/// New index of every node, `unused` for those of no triangle.
std::vector<std::int32_t> number_used_nodes(const GmshContent& content) {
  std::vector<std::int32_t> index(content.nodes.size(), unused);
  for (const auto& triangle : content.triangles) {
    for (const std::int32_t node : triangle) {
      index[static_cast<std::size_t>(node)] = 0;
    }
  }
  std::int32_t next = 0;
  for (std::int32_t& entry : index) {
    if (entry != unused) {
      entry = next++;
    }
  }
  return index;
}

/// Copies the used points. Throws InputError when they do not share one z.
void add_points(const GmshContent& content, const std::vector<std::int32_t>& index,
                GmshMesh& mesh) {
  constexpr double huge = std::numeric_limits<double>::max();
  std::array<double, 3> low{huge, huge, huge};
  std::array<double, 3> high{-huge, -huge, -huge};
  for (std::int32_t node = 0; node < static_cast<std::int32_t>(index.size()); ++node) {
    if (index[static_cast<std::size_t>(node)] == unused) {
      continue;
    }
    const std::array<double, 3>& place = content.nodes.place(node);
    mesh.points.push_back({place[0], place[1]});
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], place[axis]);
      high[axis] = std::max(high[axis], place[axis]);
    }
  }
  const double extent = std::max(high[0] - low[0], high[1] - low[1]);
  const double rounding = 1e-14 * std::max(std::abs(low[2]), std::abs(high[2]));
  if (high[2] - low[2] > 1e-8 * extent + rounding) {
    fail_mesh({mesh.file},
              fmt::format("the mesh is not plane: z runs from {:.9g} to {:.9g}; the model lies in "
                          "the x-y plane",
                          low[2], high[2]),
              "points of one and the same z");
  }
}

void add_triangles(const GmshContent& content, const std::vector<std::int32_t>& index,
                   GmshMesh& mesh) {
  mesh.triangles.reserve(content.triangles.size());
  for (const auto& nodes : content.triangles) {
    mesh.triangles.push_back({index[static_cast<std::size_t>(nodes[0])],
                              index[static_cast<std::size_t>(nodes[1])],
                              index[static_cast<std::size_t>(nodes[2])]});
  }
}

/// Names the regions in the order of their group numbers; groups of one name are one region.
void add_regions(const GmshContent& content, GmshMesh& mesh) {
  std::map<int, std::int32_t> region_of_group;
  int last = -1;
  for (const int group : content.triangle_group) {
    if (group != last) {
      region_of_group[group] = 0;
      last = group;
    }
  }
  std::map<std::string, std::int32_t> region_of_name;
  for (auto& [group, region] : region_of_group) {
    const std::string name = content.group_name(2, group);
    const auto next = static_cast<std::int32_t>(mesh.regions.size());
    const auto [found, is_new] = region_of_name.emplace(name, next);
    region = found->second;
    if (is_new) {
      mesh.regions.push_back(name);
    }
  }
  mesh.triangle_region.reserve(content.triangle_group.size());
  std::int32_t region = 0;
  last = -1;
  for (const int group : content.triangle_group) {
    if (group != last) {
      region = region_of_group[group];
      last = group;
    }
    mesh.triangle_region.push_back(region);
  }
}

/// Removes what stands twice, in whichever direction; an edge may come once for each curve.
void make_unique(std::vector<std::array<std::int32_t, 2>>& edges) {
  for (auto& edge : edges) {
    std::sort(edge.begin(), edge.end());
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
}

void make_unique(std::vector<std::int32_t>& points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

void add_curves(const GmshContent& content, const std::vector<std::int32_t>& index, GmshMesh& mesh,
                std::vector<LoosePlace>& loose) {
  for (const auto& [group, edges] : content.edges) {
    const std::string name = content.group_name(1, group);
    auto& kept = mesh.curves[name];
    for (const auto& [first, second] : edges) {
      const std::int32_t a = index[static_cast<std::size_t>(first)];
      const std::int32_t b = index[static_cast<std::size_t>(second)];
      if (a != unused && b != unused) {
        kept.push_back({a, b});
      } else {
        const Point sum = plane_place(content, first) + plane_place(content, second);
        loose.push_back({0.5 * sum, name, 1});
      }
    }
    make_unique(kept);
  }
}

void add_point_groups(const GmshContent& content, const std::vector<std::int32_t>& index,
                      GmshMesh& mesh, std::vector<LoosePlace>& loose) {
  for (const auto& [group, nodes] : content.points) {
    const std::string name = content.group_name(0, group);
    auto& kept = mesh.point_groups[name];
    for (const std::int32_t node : nodes) {
      const std::int32_t point = index[static_cast<std::size_t>(node)];
      if (point != unused) {
        kept.push_back(point);
      } else {
        loose.push_back({plane_place(content, node), name, 0});
      }
    }
    make_unique(kept);
  }
}

/// A group that the file names is there even when no edge or point of it is.
void add_empty_groups(const GmshContent& content, GmshMesh& mesh) {
  for (const auto& [key, name] : content.names) {
    if (key.first == 1) {
      mesh.curves[name];
    } else if (key.first == 0) {
      mesh.point_groups[name];
    }
  }
}

}  // namespace

GmshMesh assemble_gmsh(const GmshContent& content, const std::string& file) {
  if (content.triangles.empty()) {
    fail_mesh({file}, "the mesh has no triangles; the geometry needs a plane surface in a physical "
                      "surface, meshed with 'gmsh -2'");
  }
  GmshMesh mesh;
  mesh.file = file;
  const std::vector<std::int32_t> index = number_used_nodes(content);
  add_points(content, index, mesh);
  add_triangles(content, index, mesh);
  add_regions(content, mesh);
  std::vector<LoosePlace> loose;
  add_curves(content, index, mesh, loose);
  add_point_groups(content, index, mesh, loose);
  add_empty_groups(content, mesh);
  check_embedding(mesh, std::move(loose));
  return mesh;
}

}  // namespace percolith::mesh
