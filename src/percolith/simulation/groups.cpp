// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/groups.hpp"

#include "percolith/core/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace percolith::simulation {
namespace {

using mesh::Index;

template <class Map>
std::vector<std::string> names_of(const Map& map) {
  std::vector<std::string> names;
  names.reserve(map.size());
  for (const auto& [name, value] : map) {
    names.push_back(name);
  }
  return names;
}

void sort_unique(std::vector<Index>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

[[noreturn]] void refuse(const std::string& key, const std::string& name, const std::string& reason,
                         const std::string& allowed) {
  throw InputError({{}, key, fmt::format("\"{}\"", name), reason, allowed});
}

}  // namespace

std::string quoted_list(const std::vector<std::string>& names) {
  return names.empty() ? "none" : fmt::format("\"{}\"", fmt::join(names, "\", \""));
}

std::string entry_key(const std::string& key, std::size_t i) {
  return fmt::format("{}[{}]", key, i);
}

const mesh::CurveEdges& find_curve(const mesh::Mesh& mesh, const std::string& name,
                                   const std::string& key) {
  const auto found = mesh.curves.find(name);
  if (found != mesh.curves.end()) {
    const mesh::CurveEdges& curve = found->second;
    if (curve.joints.empty() && curve.boundary.empty() && curve.loose.empty()) {
      refuse(key, name, "no edge of this physical curve lies in the rock",
             "curves on the boundary of the rock or inside it");
    }
    return curve;
  }
  std::string reason = "the mesh has no physical curve of this name";
  if (std::find(mesh.region_names.begin(), mesh.region_names.end(), name) !=
      mesh.region_names.end()) {
    reason = "this is a physical surface (triangles), where a physical curve (edges) is needed";
  } else if (mesh.point_groups.contains(name)) {
    reason = "this is a physical point, where a physical curve (edges) is needed";
  }
  refuse(key, name, reason, quoted_list(names_of(mesh.curves)));
}

std::vector<Index> fracture_joints(const mesh::Mesh& mesh, const std::vector<std::string>& groups,
                                   const std::string& key) {
  std::vector<Index> joints;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const std::string at = entry_key(key, i);
    const mesh::CurveEdges& curve = find_curve(mesh, groups[i], at);
    if (!curve.loose.empty()) {
      refuse(at, groups[i],
             fmt::format("{} of its edges are not edges of triangles: the curve leaves the rock or "
                         "is not embedded in its surface",
                         curve.loose.size()),
             "curves embedded in the geometry with `Curve{...} In Surface{...};` or fragmented "
             "with the surface");
    }
    if (!curve.boundary.empty()) {
      const Point p =
          mesh.middle_of(mesh.boundary[static_cast<std::size_t>(curve.boundary[0])].vertex);
      refuse(at, groups[i],
             fmt::format("its edge at ({:g}, {:g}) lies on the boundary of the rock, and a "
                         "fracture needs rock on both sides",
                         p.x, p.y),
             "curves inside the rock; they may end at the boundary");
    }
    joints.insert(joints.end(), curve.joints.begin(), curve.joints.end());
  }
  sort_unique(joints);
  return joints;
}

std::vector<Index> boundary_edges(const mesh::Mesh& mesh, const std::vector<std::string>& groups,
                                  const std::string& key) {
  std::vector<Index> edges;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const std::string at = entry_key(key, i);
    const mesh::CurveEdges& curve = find_curve(mesh, groups[i], at);
    if (!curve.joints.empty() || !curve.loose.empty()) {
      std::string where;
      if (!curve.joints.empty()) {
        const Point p =
            mesh.middle_of(mesh.joint[static_cast<std::size_t>(curve.joints[0])].vertex);
        where = fmt::format(" at ({:g}, {:g})", p.x, p.y);
      }
      refuse(at, groups[i],
             fmt::format("{} of its edges{} are not on the boundary of the rock",
                         curve.joints.size() + curve.loose.size(), where),
             "curves on the outer boundary or round a hole; for a curve inside use a fracture or "
             "a source");
    }
    edges.insert(edges.end(), curve.boundary.begin(), curve.boundary.end());
  }
  sort_unique(edges);
  return edges;
}

std::vector<Index> find_regions(const mesh::Mesh& mesh, const std::vector<std::string>& names,
                                const std::string& key) {
  std::vector<Index> regions;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto found = std::find(mesh.region_names.begin(), mesh.region_names.end(), names[i]);
    if (found == mesh.region_names.end()) {
      refuse(entry_key(key, i), names[i], "the mesh has no physical surface of this name",
             quoted_list(mesh.region_names));
    }
    regions.push_back(static_cast<Index>(found - mesh.region_names.begin()));
  }
  return regions;
}

std::vector<std::string> material_of_regions(const Setup& setup, const mesh::Mesh& mesh) {
  std::vector<std::string> owner(mesh.region_names.size());
  for (const auto& [name, material] : setup.material) {
    const std::string key = "material." + name + ".regions";
    const std::vector<Index> regions = find_regions(mesh, material.regions, key);
    for (std::size_t i = 0; i < regions.size(); ++i) {
      std::string& present = owner[static_cast<std::size_t>(regions[i])];
      if (!present.empty()) {
        refuse(entry_key(key, i), material.regions[i],
               fmt::format("this region already has material.{}", present),
               "one material per region");
      }
      present = name;
    }
  }
  for (std::size_t r = 0; r < owner.size(); ++r) {
    if (owner[r].empty()) {
      throw InputError(
          {{},
           "material",
           "",
           fmt::format("region \"{}\" of the mesh has no material", mesh.region_names[r]),
           "every physical surface named in the regions of one material"});
    }
  }
  return owner;
}

}  // namespace percolith::simulation
