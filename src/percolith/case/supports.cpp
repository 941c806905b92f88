// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/supports.hpp"

#include <array>

namespace percolith::case_file {

namespace {

using simulation::BoundaryCondition;

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

}  // namespace percolith::case_file
