// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/report.hpp"

#include <fmt/format.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/variant.h>
#include <nanobind/stl/vector.h>

#include "member_docs.hpp"
#include "modules.hpp"

namespace nb = nanobind;

namespace percolith::python {
namespace {

using simulation::CheckReport;
using simulation::StepLimit;

std::pair<double, double> place_of(const Point& point) {
  return {point.x, point.y};
}

/// The numbers about mechanics by their names, in the order that `percolith check` has.
nb::dict mechanics_of(const CheckReport& report) {
  nb::dict named;
  for (const auto& [name, value] : report.mechanics) {
    const nb::str key(name.data(), name.size());
    named[key] = nb::cast(value);
  }
  return named;
}

}  // namespace

void bind_reports(nb::module_& module) {
  nb::class_<StepLimit>(module, "StepLimit", docs::StepLimit)
      .def_ro("mechanism", &StepLimit::mechanism, docs::StepLimit_mechanism)
      .def_ro("step", &StepLimit::step, docs::StepLimit_step)
      .def_prop_ro(
          "place", [](const StepLimit& limit) { return place_of(limit.place); },
          docs::StepLimit_place)
      .def("__repr__", [](const StepLimit& limit) {
        return nb::str("StepLimit({!r}, {:g} s at ({:g}, {:g}) m)")
            .format(limit.mechanism, limit.step, limit.place.x, limit.place.y);
      });
  nb::class_<CheckReport>(module, "CheckReport", docs::CheckReport)
      .def_ro("triangles", &CheckReport::triangles, "Number of triangles.")
      .def_ro("vertices", &CheckReport::vertices, "Number of vertices.")
      .def_ro("joints", &CheckReport::joints, "Number of joints, the interior edges.")
      .def_ro("broken_joints", &CheckReport::broken_joints, "Number of those broken now.")
      .def_ro("boundary_edges", &CheckReport::boundary_edges, "Number of edges of one triangle.")
      .def_ro("pore_nodes", &CheckReport::pore_nodes, "Number of pore nodes.")
      .def_ro("crack_nodes", &CheckReport::crack_nodes, "Number of open crack nodes.")
      .def_ro("unknowns", &CheckReport::unknowns, "Unknowns of an implicit step.")
      .def_ro("area", &CheckReport::area, docs::CheckReport_area)
      .def_prop_ro(
          "lower_corner", [](const CheckReport& report) { return place_of(report.lower_corner); },
          docs::CheckReport_lower_corner)
      .def_prop_ro(
          "upper_corner", [](const CheckReport& report) { return place_of(report.upper_corner); },
          docs::CheckReport_upper_corner)
      .def_ro("smallest_edge", &CheckReport::smallest_edge, docs::CheckReport_smallest_edge)
      .def_ro("largest_edge", &CheckReport::largest_edge, docs::CheckReport_largest_edge)
      .def_ro("smallest_angle", &CheckReport::smallest_angle, docs::CheckReport_smallest_angle)
      .def_ro("largest_angle", &CheckReport::largest_angle, docs::CheckReport_largest_angle)
      .def_prop_ro(
          "smallest_angle_place",
          [](const CheckReport& report) { return place_of(report.smallest_angle_place); },
          docs::CheckReport_smallest_angle_place)
      .def_ro("fracture_length", &CheckReport::fracture_length, docs::CheckReport_fracture_length)
      .def_ro("region_area", &CheckReport::region_area, docs::CheckReport_region_area)
      .def_ro("fracture_length_by_group", &CheckReport::fracture_length_by_group,
              docs::CheckReport_fracture_length_by_group)
      .def_ro("limits", &CheckReport::limits, docs::CheckReport_limits)
      .def_prop_ro("mechanics", &mechanics_of,
                   nb::for_getter(nb::sig("def mechanics(self) -> dict[str, float | int]")),
                   docs::CheckReport_mechanics)
      .def_ro("warnings", &CheckReport::warnings, "Warnings about the model.")
      .def("__repr__", [](const CheckReport& report) {
        const std::string limit =
            report.limits.empty()
                ? "no limit of the time step"
                : fmt::format("explicit steps below {:.4g} s", report.limits.back().step);
        return fmt::format(
            "CheckReport({} triangles, {} joints, {} of them broken; {}; {} warnings)",
            report.triangles, report.joints, report.broken_joints, limit, report.warnings.size());
      });
}

}  // namespace percolith::python
