// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/error.hpp"
#include "percolith/mesh/joint_finder.hpp"
#include "percolith/mesh/triangle_finder.hpp"
#include "percolith/simulation/build_model.hpp"
#include "percolith/simulation/condition_list.hpp"
#include "percolith/simulation/groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace percolith::simulation {
namespace {

using mesh::Index;

std::vector<Index> vertices_of(const mesh::Mesh& mesh, const std::vector<Index>& edges) {
  std::vector<Index> vertices;
  for (const Index e : edges) {
    const auto& ends = mesh.boundary[at(e)].vertex;
    vertices.insert(vertices.end(), ends.begin(), ends.end());
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

double edge_length(const mesh::Mesh& mesh, const mesh::BoundaryEdge& edge) {
  const Point along = mesh.vertex[at(edge.vertex[1])] - mesh.vertex[at(edge.vertex[0])];
  return std::sqrt(dot(along, along));
}

void prescribe(ConditionList& list, Domain on, Index vertex, double factor, double offset) {
  if (on != Domain::crack) {
    list.prescribe_pores(vertex, factor, offset);
  }
  if (on != Domain::matrix) {
    list.prescribe_crack(vertex, factor, offset);
  }
}

void add_boundary(const Setup& setup, const seepage::Model& model, const std::string& name,
                  const BoundaryCondition& boundary, ConditionList& list) {
  if (!boundary.pressure && !boundary.head && !boundary.flux && !boundary.seepage_face) {
    return;  // impervious: a condition of the motion alone
  }
  const mesh::Mesh& mesh = model.mesh;
  const std::string path = "boundary." + name;
  const std::string groups_key = path + ".groups";
  const std::vector<Index> edges = boundary_edges(mesh, boundary.groups, groups_key);
  const double weight = setup.fluid.density * setup.model.gravity;
  if (boundary.flux) {
    list.begin(path, "flux", *boundary.flux);
    for (const Index e : edges) {
      const mesh::BoundaryEdge& edge = mesh.boundary[at(e)];
      list.rate_into_corner(edge.corner[0], 0.5 * edge_length(mesh, edge));
      list.rate_into_corner(edge.corner[1], 0.5 * edge_length(mesh, edge));
    }
  } else if (boundary.seepage_face) {
    list.begin(path, "seepage_face", *boundary.seepage_face);
    for (const Index v : vertices_of(mesh, edges)) {
      if (boundary.on != Domain::crack) {
        list.seepage_face_pores(v);
      }
      if (boundary.on != Domain::matrix) {
        list.seepage_face_crack(v);
      }
    }
  } else if (boundary.head) {
    list.begin(path, "head", *boundary.head);
    for (const Index v : vertices_of(mesh, edges)) {
      const double elevation = mesh.vertex[at(v)].y - setup.model.head_datum;
      prescribe(list, boundary.on, v, weight, -weight * elevation);
    }
  } else {
    list.begin(path, "pressure", boundary.pressure.value_or(Schedule{}));
    for (const Index v : vertices_of(mesh, edges)) {
      prescribe(list, boundary.on, v, 1.0, 0.0);
    }
  }
  for (const Index e : edges) {
    list.claim_edge(e, groups_key);
  }
}

[[noreturn]] void refuse_point(const std::string& key, const std::array<double, 2>& p,
                               const std::string& reason, const std::string& allowed) {
  throw InputError({{}, key, fmt::format("[{:g}, {:g}]", p[0], p[1]), reason, allowed});
}

void add_point_in_matrix(const seepage::Model& model, const Source& source, const std::string& path,
                         ConditionList& list) {
  const std::array<double, 2>& p = *source.point;
  if (!source.rate) {
    throw InputError({{},
                      path + ".pressure",
                      "",
                      "a pressure at a single point of the matrix has no meaning: the flow it "
                      "drives depends on the mesh",
                      "a rate, or a point in a crack, or a boundary round a hole"});
  }
  const auto place = mesh::TriangleFinder(model.mesh).find({p[0], p[1]});
  if (!place) {
    refuse_point(path + ".point", p, "the point lies outside of the rock",
                 "points inside the mesh");
  }
  list.begin(path, "rate", *source.rate);
  for (Index k = 0; k < 3; ++k) {
    if (place->weight[at(k)] > 0.0) {
      list.rate_into_corner(mesh::corner_of(place->triangle, k), place->weight[at(k)]);
    }
  }
}

void add_point_in_crack(const seepage::Model& model, const Source& source, const std::string& path,
                        ConditionList& list) {
  const std::array<double, 2>& p = *source.point;
  const auto place = nearest_joint(model.mesh, model.cracks.broken_joints(), {p[0], p[1]});
  if (!place) {
    refuse_point(path + ".point", p, "the model has no open crack",
                 "a fracture table, or into = "
                 "\"matrix\"");
  }
  const auto& ends = model.mesh.joint[at(place->joint)].vertex;
  const Point a = model.mesh.vertex[at(ends[0])];
  const Point nearest = a + place->fraction * (model.mesh.vertex[at(ends[1])] - a);
  if (place->distance > 0.5 * model.mesh.joint_length(place->joint)) {
    refuse_point(path + ".point", p, "the point does not lie on an open crack",
                 fmt::format("a point on a fracture; the nearest is ({:.6g}, {:.6g})", nearest.x,
                             nearest.y));
  }
  if (source.rate) {
    list.begin(path, "rate", *source.rate);
    list.rate_into_crack(ends[0], 1.0 - place->fraction);
    list.rate_into_crack(ends[1], place->fraction);
  } else {
    list.begin(path, "pressure", source.pressure.value_or(Schedule{}));
    list.prescribe_crack(ends[place->fraction < 0.5 ? 0 : 1], 1.0, 0.0);
  }
}

std::vector<Index> joints_of_fractures(const Setup& setup, const seepage::Model& model,
                                       const Source& source, const std::string& path) {
  std::vector<Index> joints;
  for (std::size_t i = 0; i < source.fractures.size(); ++i) {
    const auto found = setup.fracture.find(source.fractures[i]);
    if (found == setup.fracture.end()) {
      throw InputError({{},
                        entry_key(path + ".fractures", i),
                        fmt::format("\"{}\"", source.fractures[i]),
                        "there is no fracture table of this name",
                        quoted_list(fracture_table_names(setup))});
    }
    const auto group = static_cast<Index>(std::distance(setup.fracture.begin(), found));
    for (const Index j : model.cracks.broken_joints()) {
      if (model.crack.group[at(j)] == group) {
        joints.push_back(j);
      }
    }
  }
  std::sort(joints.begin(), joints.end());
  joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
  return joints;
}

void add_source_in_fractures(const Setup& setup, const seepage::Model& model, const Source& source,
                             const std::string& path, ConditionList& list) {
  const std::vector<Index> joints = joints_of_fractures(setup, model, source, path);
  if (joints.empty()) {
    throw InputError({{},
                      path + ".fractures",
                      quoted_list(source.fractures),
                      "the fracture is bonded, so that there is no crack to bring fluid into",
                      "a fracture with bond = \"broken\""});
  }
  double length = 0.0;
  for (const Index j : joints) {
    length += model.mesh.joint_length(j);
  }
  if (source.rate) {
    list.begin(path, "rate", *source.rate);
  } else {
    list.begin(path, "pressure", source.pressure.value_or(Schedule{}));
  }
  for (const Index j : joints) {
    for (const Index v : model.mesh.joint[at(j)].vertex) {
      if (source.rate) {
        list.rate_into_crack(v, 0.5 * model.mesh.joint_length(j) / length);
      } else {
        list.prescribe_crack(v, 1.0, 0.0);
      }
    }
  }
}

}  // namespace

seepage::Conditions build_conditions(const Setup& setup, const seepage::Model& model) {
  ConditionList list(model);
  for (const auto& [name, boundary] : setup.boundary) {
    add_boundary(setup, model, name, boundary, list);
  }
  for (const auto& [name, source] : setup.source) {
    const std::string path = "source." + name;
    if (!source.point) {
      add_source_in_fractures(setup, model, source, path, list);
    } else if (source.into == Domain::crack) {
      add_point_in_crack(model, source, path, list);
    } else {
      add_point_in_matrix(model, source, path, list);
    }
  }
  return list.take();
}

}  // namespace percolith::simulation
