// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/boundary_supports.hpp"

#include <array>
#include <optional>

namespace percolith::simulation {

namespace {

constexpr std::array<Support, 12> all_supports{{
    {"fixed", [](const BoundaryCondition& c) { return c.fixed; }},
    {"roller", [](const BoundaryCondition& c) { return c.roller; }},
    {"displacement_x", [](const BoundaryCondition& c) { return c.displacement_x.has_value(); }},
    {"displacement_y", [](const BoundaryCondition& c) { return c.displacement_y.has_value(); }},
    {"velocity_x", [](const BoundaryCondition& c) { return c.velocity_x.has_value(); }},
    {"velocity_y", [](const BoundaryCondition& c) { return c.velocity_y.has_value(); }},
    {"traction_x", [](const BoundaryCondition& c) { return c.traction_x.has_value(); }},
    {"traction_y", [](const BoundaryCondition& c) { return c.traction_y.has_value(); }},
    {"normal_pressure", [](const BoundaryCondition& c) { return c.normal_pressure.has_value(); }},
    {"pressurised", [](const BoundaryCondition& c) { return c.pressurised; }},
    {"in_situ", [](const BoundaryCondition& c) { return c.in_situ; }},
    {"absorbing", [](const BoundaryCondition& c) { return c.absorbing; }},
}};

}  // namespace

std::span<const Support> supports() {
  return all_supports;
}

bool holds_rock(const BoundaryCondition& condition) {
  const auto pushes = [](const std::optional<Schedule>& load) {
    return load && load->largest() != 0.0;
  };
  return condition.fixed || condition.roller || condition.in_situ || condition.displacement_x ||
         condition.displacement_y || condition.velocity_x || condition.velocity_y ||
         pushes(condition.traction_x) || pushes(condition.traction_y) ||
         pushes(condition.normal_pressure) ||
         (condition.pressurised && (pushes(condition.pressure) || pushes(condition.head)));
}

}  // namespace percolith::simulation
