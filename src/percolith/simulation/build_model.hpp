// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/gmsh_mesh.hpp"
#include "percolith/seepage/model.hpp"
#include "percolith/simulation/setup.hpp"

#include <string>
#include <vector>

namespace percolith::simulation {

/// Mesh, materials and fractures of a setup as a flow model with its initial state and conditions
/// at time zero. Throws InputError, with the option path as key, for what does not fit together.
[[nodiscard]] seepage::Model build_model(const Setup& setup, const mesh::GmshMesh& file);

/// Boundary conditions and sources, by node. Fractures must have been broken. Throws InputError
/// for unknown groups, edges or nodes with two conditions, and places outside the rock.
[[nodiscard]] seepage::Conditions build_conditions(const Setup& setup, const seepage::Model& model);

/// Pressure (Pa) that `[initial]` gives the rock at a place, not below the cavitation pressure and
/// whatever conditions hold there; without meaning with `initial.steady`.
[[nodiscard]] double initial_pressure(const Setup& setup, const seepage::Model& model,
                                      const Point& place);

/// Sets the state at time zero, prescribed pressures included.
void set_initial_state(const Setup& setup, seepage::Model& model);

/// Names of the fracture tables in the order of the model's fracture groups; the group of new
/// cracks, where there is one, comes after them.
[[nodiscard]] std::vector<std::string> fracture_table_names(const Setup& setup);

}  // namespace percolith::simulation
