// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "member_docs.hpp"
#include "modules.hpp"
#include "states.hpp"
#include "views.hpp"

namespace percolith::python {
namespace {

using mesh::Index;

View<double> vertices(const MeshView& view, nb::handle self) {
  static_assert(sizeof(Point) == 2 * sizeof(double));
  const auto& points = view.mesh->vertex;
  return {points.empty() ? nullptr : &points.front().x, {points.size(), 2}, self};
}

View<Index> triangles(const MeshView& view, nb::handle self) {
  const auto& rows = view.mesh->triangle_vertex;
  return {rows.empty() ? nullptr : rows.front().data(), {rows.size(), 3}, self};
}

// A joint is stored as two vertices and four corners, one after the other.
constexpr std::int64_t joint_stride = sizeof(mesh::Joint) / sizeof(Index);

View<Index> joint_vertices(const MeshView& view, nb::handle self) {
  const auto& joints = view.mesh->joint;
  return {joints.empty() ? nullptr : joints.front().vertex.data(),
          {joints.size(), 2},
          self,
          {joint_stride, 1}};
}

View<Index> joint_corners(const MeshView& view, nb::handle self) {
  const auto& joints = view.mesh->joint;
  return {joints.empty() ? nullptr : joints.front().corner.front().data(),
          {joints.size(), 2, 2},
          self,
          {joint_stride, 2, 1}};
}

}  // namespace

void bind_mesh(nb::module_& module) {
  nb::class_<MeshView>(module, "Mesh", docs::Mesh)
      .def_prop_ro(
          "vertices", [](nb::handle self) { return vertices(nb::cast<MeshView&>(self), self); },
          "(vertices, 2), m: places of the vertices, undeformed.")
      .def_prop_ro(
          "triangles", [](nb::handle self) { return triangles(nb::cast<MeshView&>(self), self); },
          "(triangles, 3): vertices of each triangle, counter-clockwise.")
      .def_prop_ro(
          "region",
          [](nb::handle self) { return list_view(nb::cast<MeshView&>(self).mesh->region, self); },
          shaped("(triangles,)", docs::Mesh_region).c_str())
      .def_prop_ro(
          "region_names", [](const MeshView& v) { return v.mesh->region_names; },
          "Names of the regions.")
      .def_prop_ro(
          "joint_vertices",
          [](nb::handle self) { return joint_vertices(nb::cast<MeshView&>(self), self); },
          "(joints, 2): vertices at the ends of each joint, the interior edges.")
      .def_prop_ro(
          "joint_corners",
          [](nb::handle self) { return joint_corners(nb::cast<MeshView&>(self), self); },
          "(joints, 2, 2): corner slots of each joint, [joint, side, end].");
}

}  // namespace percolith::python
