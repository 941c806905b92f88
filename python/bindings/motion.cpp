// SPDX-License-Identifier: BSD-3-Clause
#include "member_docs.hpp"
#include "modules.hpp"
#include "states.hpp"
#include "views.hpp"

namespace percolith::python {
namespace {

template <class Array>
auto corners(Array array) {
  return [array](nb::handle self) {
    return corner_view(array(*nb::cast<MotionView&>(self).model), self);
  };
}

using mechanics::Model;
using Doubles = const std::vector<double>&;

/// States of the joints as numbers, in the order of `mechanics::JointState`.
View<std::uint8_t> joint_state(nb::handle self) {
  const auto& states = nb::cast<MotionView&>(self).model->joints.state;
  const auto* first = reinterpret_cast<const std::uint8_t*>(states.data());
  return list_view(std::span(first, at(nb::cast<MotionView&>(self).model->mesh.joints())), self);
}

template <std::size_t Point>
View<double> joint_damage(nb::handle self) {
  const mechanics::Model& model = *nb::cast<MotionView&>(self).model;
  return list_view(
      std::span<const double>(model.joints.damage[Point]).first(at(model.mesh.joints())), self);
}

}  // namespace

void bind_motion(nb::module_& module) {
  nb::class_<MotionView>(module, "Motion", docs::Motion)
      .def_prop_ro("displacement_x", corners([](const Model& m) -> Doubles { return m.motion.ux; }),
                   shaped("(blocks, 8, 3)", docs::Motion_ux).c_str())
      .def_prop_ro("displacement_y", corners([](const Model& m) -> Doubles { return m.motion.uy; }),
                   shaped("(blocks, 8, 3)", docs::Motion_uy).c_str())
      .def_prop_ro("velocity_x", corners([](const Model& m) -> Doubles { return m.motion.vx; }),
                   shaped("(blocks, 8, 3)", docs::Motion_vx).c_str())
      .def_prop_ro("velocity_y", corners([](const Model& m) -> Doubles { return m.motion.vy; }),
                   shaped("(blocks, 8, 3)", docs::Motion_vy).c_str())
      .def_prop_ro("joint_state", &joint_state,
                   "(joints,): 0 tied, 1 rigid, 2 bonded, 3 closed, 4 broken.")
      .def_prop_ro("joint_damage_0", &joint_damage<0>,
                   "(joints,), 1: damage at the first integration point, 1 where it has failed.")
      .def_prop_ro("joint_damage_1", &joint_damage<1>,
                   "(joints,), 1: damage at the second integration point.");
}

}  // namespace percolith::python
