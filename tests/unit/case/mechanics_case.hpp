// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "unit/case/minimal_case.hpp"

namespace percolith::case_file {

/// A small valid case of mechanics; a test replaces parts of it.
inline const std::string mechanics_case = R"(format = 1

[mesh]
file = "block.msh"

[model]
physics = "mechanics"
gravity = 0

[material.rock]
regions = ["rock"]
density = 2700
young_modulus = "50 GPa"
poisson_ratio = 0.25
tensile_strength = "10 MPa"
cohesion = "20 MPa"
friction_angle = "30 deg"
mode_1_energy = 10
mode_2_energy = 100

[boundary.base]
groups = ["bottom"]
fixed = true

[time]
end = "10 ms"
)";

/// The same with fluid in its pores and cracks.
inline const std::string coupled_case = R"(format = 1

[mesh]
file = "block.msh"

[model]
physics = "coupled"
gravity = 0

[material.rock]
regions = ["rock"]
density = 2700
permeability = 1e-15
porosity = 0.1
young_modulus = "50 GPa"
poisson_ratio = 0.25
tensile_strength = "10 MPa"
cohesion = "20 MPa"
friction_angle = "30 deg"
mode_1_energy = 10
mode_2_energy = 100

[new_cracks]
initial_aperture = "0.1 mm"
exchange = 1e-9

[boundary.base]
groups = ["bottom"]
fixed = true

[boundary.wall]
groups = ["wall"]
pressure = "1 MPa"
pressurised = true

[time]
end = "10 ms"
)";

/// As error_of, for the small coupled case with options set.
inline std::string coupled_error(const std::vector<std::string>& overrides) {
  return error_of(coupled_case, overrides);
}

/// As error_of, for the small case of mechanics with options set.
inline std::string mechanics_error(const std::vector<std::string>& overrides) {
  return error_of(mechanics_case, overrides);
}

}  // namespace percolith::case_file
