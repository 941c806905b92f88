// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/pumped_mouths.hpp"

#include "percolith/simulation/groups.hpp"

#include <fmt/format.h>

#include <optional>
#include <set>

namespace percolith::simulation {
namespace {

using mesh::Index;

std::set<Index> vertices_on(const mesh::Mesh& mesh, const BoundaryCondition& boundary,
                            const std::string& path) {
  std::set<Index> vertices;
  for (const Index e : boundary_edges(mesh, boundary.groups, path + ".groups")) {
    const auto& ends = mesh.boundary[at(e)].vertex;
    vertices.insert(ends.begin(), ends.end());
  }
  return vertices;
}

/// The first vertex of the fracture that is one of `vertices`.
std::optional<Index> meeting_point(const mesh::Mesh& mesh, const std::vector<Index>& joints,
                                   const std::set<Index>& vertices) {
  for (const Index j : joints) {
    for (const Index v : mesh.joint[at(j)].vertex) {
      if (vertices.contains(v)) {
        return v;
      }
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string> pumped_mouth_warnings(const Setup& setup, const mesh::Mesh& mesh) {
  std::vector<std::string> warnings;
  for (const auto& [boundary_name, boundary] : setup.boundary) {
    if (!boundary.normal_pressure || boundary.pressurised) {
      continue;
    }
    const std::string opening = "boundary." + boundary_name;
    const std::set<Index> vertices = vertices_on(mesh, boundary, opening);
    for (const auto& [source_name, source] : setup.source) {
      for (const std::string& name : source.fractures) {
        const std::string path = "fracture." + name;
        const auto joints = fracture_joints(mesh, setup.fracture.at(name).groups, path + ".groups");
        if (const auto v = meeting_point(mesh, joints, vertices)) {
          warnings.push_back(fmt::format(
              "{}, which source.{} pumps into, ends on {} at ({:g}, {:g}), but the fluid there "
              "keeps to {}.normal_pressure: a higher pressure in the fracture pushes the rock "
              "between both into the opening. Where one fluid fills both, give the boundary its "
              "pressure and pressurised = true instead of the source",
              path, source_name, opening, mesh.vertex[at(*v)].x, mesh.vertex[at(*v)].y, opening));
        }
      }
    }
  }
  return warnings;
}

}  // namespace percolith::simulation
