// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/stl/vector.h>

#include "member_docs.hpp"
#include "modules.hpp"
#include "states.hpp"
#include "views.hpp"

namespace percolith::python {
namespace {

/// A property that shows an array of the flow per corner slot.
template <class Array>
auto corners(Array array) {
  return [array](nb::handle self) {
    return corner_view(array(*nb::cast<FlowView&>(self).model), self);
  };
}

/// The same for an array with one value an element.
template <class Array>
auto list(Array array) {
  return
      [array](nb::handle self) { return list_view(array(*nb::cast<FlowView&>(self).model), self); };
}

using seepage::Model;
using Doubles = const std::vector<double>&;

}  // namespace

void bind_flow(nb::module_& module) {
  nb::class_<FlowView>(module, "Flow", docs::State)
      .def_prop_ro("pressure", corners([](const Model& m) -> Doubles { return m.state.pressure; }),
                   shaped("(blocks, 8, 3)", docs::State_pressure).c_str())
      .def_prop_ro("saturation",
                   corners([](const Model& m) -> Doubles { return m.state.saturation; }),
                   shaped("(blocks, 8, 3)", docs::State_saturation).c_str())
      .def_prop_ro("content", corners([](const Model& m) -> Doubles { return m.state.content; }),
                   shaped("(blocks, 8, 3)", docs::State_content).c_str())
      .def_prop_ro("crack_pressure",
                   list([](const Model& m) -> Doubles { return m.state.crack_pressure; }),
                   shaped("(vertices,)", docs::State_crack_pressure).c_str())
      .def_prop_ro("crack_saturation",
                   list([](const Model& m) -> Doubles { return m.state.crack_saturation; }),
                   shaped("(vertices,)", docs::State_crack_saturation).c_str())
      .def_prop_ro("crack_content",
                   list([](const Model& m) -> Doubles { return m.state.crack_content; }),
                   shaped("(vertices,)", docs::State_crack_content).c_str())
      .def_prop_ro("aperture", list([](const Model& m) -> Doubles { return m.crack.aperture; }),
                   shaped("(joints,)", docs::CrackProperties_aperture).c_str())
      .def_prop_ro("crack_group", list([](const Model& m) -> const std::vector<mesh::Index>& {
                     return m.crack.group;
                   }),
                   shaped("(joints,)", docs::CrackProperties_group).c_str())
      .def_prop_ro(
          "pore_nodes", [](const FlowView& v) { return v.model->pore_nodes.nodes(v.model->mesh); },
          "Corner slots of the leaders of all pore nodes, a list.")
      .def_prop_ro(
          "crack_nodes",
          [](const FlowView& v) {
            const auto nodes = v.model->cracks.open_nodes();
            return std::vector<mesh::Index>(nodes.begin(), nodes.end());
          },
          "Vertices of the open crack nodes, a list.")
      .def_prop_ro(
          "broken_joints",
          [](const FlowView& v) {
            const auto joints = v.model->cracks.broken_joints();
            return std::vector<mesh::Index>(joints.begin(), joints.end());
          },
          "Joints of the crack network, a list.");
}

}  // namespace percolith::python
