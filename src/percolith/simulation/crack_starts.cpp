// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/crack_starts.hpp"

#include "percolith/mesh/joint_finder.hpp"
#include "percolith/mesh/triangle_finder.hpp"
#include "percolith/simulation/groups.hpp"

#include <algorithm>
#include <cstdint>
#include <map>

namespace percolith::simulation {
namespace {

using mesh::Index;

/// By vertex, what was found there first.
using Starts = std::map<Index, std::string>;

std::vector<std::uint8_t> on_boundary(const mesh::Mesh& mesh) {
  std::vector<std::uint8_t> result(mesh.vertex.size(), 0);
  for (const mesh::BoundaryEdge& edge : mesh.boundary) {
    result[at(edge.vertex[0])] = 1;
    result[at(edge.vertex[1])] = 1;
  }
  return result;
}

/// Where two fractures meet neither ends.
void add_ends(const Setup& setup, const mesh::Mesh& mesh, Starts& starts) {
  std::vector<Index> meeting(mesh.vertex.size(), 0);
  std::map<Index, std::string> ends;  // vertex, the last fracture there
  for (const auto& [name, group] : setup.fracture) {
    if (group.bond == Bond::broken) {
      const std::string path = "fracture." + name;
      for (const Index j : fracture_joints(mesh, group.groups, path + ".groups")) {
        for (const Index v : mesh.joint[at(j)].vertex) {
          ++meeting[at(v)];
          ends[v] = path;
        }
      }
    }
  }
  const std::vector<std::uint8_t> outside = on_boundary(mesh);
  for (const auto& [v, path] : ends) {
    if (meeting[at(v)] == 1 && outside[at(v)] == 0) {
      starts.emplace(v, "the end of " + path);
    }
  }
}

/// A cohesive fracture opens from where something else starts it, else anywhere.
void add_cohesive(const Setup& setup, const mesh::Mesh& mesh, Starts& starts) {
  const Starts others = starts;
  for (const auto& [name, group] : setup.fracture) {
    if (group.bond != Bond::cohesive) {
      continue;
    }
    const std::string path = "fracture." + name;
    Starts along;
    for (const Index j : fracture_joints(mesh, group.groups, path + ".groups")) {
      along.emplace(mesh.joint[at(j)].vertex[0], path);
      along.emplace(mesh.joint[at(j)].vertex[1], path);
    }
    if (std::none_of(along.begin(), along.end(),
                     [&](const auto& entry) { return others.contains(entry.first); })) {
      starts.merge(along);
    }
  }
}

/// Joints of the fractures that are open from the start.
std::vector<Index> open_joints(const Setup& setup, const mesh::Mesh& mesh) {
  std::vector<Index> joints;
  for (const auto& [name, group] : setup.fracture) {
    if (group.bond == Bond::broken) {
      const auto more = fracture_joints(mesh, group.groups, "fracture." + name + ".groups");
      joints.insert(joints.end(), more.begin(), more.end());
    }
  }
  std::sort(joints.begin(), joints.end());
  return joints;
}

void add_sources(const Setup& setup, const mesh::Mesh& mesh, Starts& starts) {
  for (const auto& [name, source] : setup.source) {
    if (!source.point) {
      continue;  // along a fracture, whose ends are known
    }
    const Point p{(*source.point)[0], (*source.point)[1]};
    const std::string what = "source." + name;
    if (source.into == Domain::crack) {
      if (const auto place = mesh::nearest_joint(mesh, open_joints(setup, mesh), p)) {
        for (const Index v : mesh.joint[at(place->joint)].vertex) {
          starts.emplace(v, what);
        }
      }
    } else if (const auto place = mesh::TriangleFinder(mesh).find(p)) {
      for (const Index v : mesh.triangle_vertex[at(place->triangle)]) {
        starts.emplace(v, what);
      }
    }
  }
}

/// Whether the pressure of a boundary is that of the rock at the start and stays so.
bool keeps_the_start(const Initial& initial, const BoundaryCondition& condition) {
  return condition.pressure && condition.pressure->is_constant() &&
         (initial.steady || initial.pressure == condition.pressure->at(0.0));
}

void add_pressed_boundaries(const Setup& setup, const mesh::Mesh& mesh, Starts& starts) {
  for (const auto& [name, condition] : setup.boundary) {
    if (!condition.pressurised || keeps_the_start(setup.initial, condition)) {
      continue;
    }
    const std::string path = "boundary." + name;
    for (const Index e : boundary_edges(mesh, condition.groups, path + ".groups")) {
      for (const Index v : mesh.boundary[at(e)].vertex) {
        starts.emplace(v, path);
      }
    }
  }
}

void add_excavations(const Setup& setup, const mesh::Mesh& mesh, Starts& starts) {
  for (const auto& [name, excavation] : setup.excavation) {
    const std::string path = "excavation." + name;
    const std::vector<Index> regions = find_regions(mesh, excavation.regions, path + ".regions");
    const auto is_dug = [&](Index corner) {
      const Index region = mesh.region[at(mesh::triangle_of(corner))];
      return std::find(regions.begin(), regions.end(), region) != regions.end();
    };
    for (const mesh::Joint& joint : mesh.joint) {
      if (is_dug(joint.corner[0][0]) != is_dug(joint.corner[1][0])) {
        starts.emplace(joint.vertex[0], "the wall of " + path);
        starts.emplace(joint.vertex[1], "the wall of " + path);
      }
    }
  }
}

}  // namespace

std::vector<Index> hole_vertices(const mesh::Mesh& mesh) {
  std::multimap<Index, std::size_t> edge_from;
  for (std::size_t e = 0; e < mesh.boundary.size(); ++e) {
    edge_from.emplace(mesh.boundary[e].vertex[0], e);
  }
  std::vector<Index> vertices;
  while (!edge_from.empty()) {
    // Walking on from edge to edge uses up a loop; it leaves the rock on its left.
    std::vector<Index> loop;
    double area = 0.0;
    for (auto next = edge_from.begin(); next != edge_from.end();) {
      const auto& ends = mesh.boundary[next->second].vertex;
      const Point a = mesh.vertex[at(ends[0])];
      const Point b = mesh.vertex[at(ends[1])];
      area += 0.5 * (a.x * b.y - a.y * b.x);
      loop.push_back(ends[0]);
      edge_from.erase(next);
      next = edge_from.find(ends[1]);
    }
    if (area < 0.0) {
      vertices.insert(vertices.end(), loop.begin(), loop.end());
    }
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

std::vector<CrackStart> crack_starts(const Setup& setup, const mesh::Mesh& mesh) {
  Starts starts;
  add_ends(setup, mesh, starts);
  add_sources(setup, mesh, starts);
  add_pressed_boundaries(setup, mesh, starts);
  add_excavations(setup, mesh, starts);
  for (const Index v : hole_vertices(mesh)) {
    starts.emplace(v, "the wall of a hole");
  }
  add_cohesive(setup, mesh, starts);
  std::vector<CrackStart> result;
  result.reserve(starts.size());
  for (auto& [v, what] : starts) {
    result.push_back({v, what});
  }
  return result;
}

}  // namespace percolith::simulation
