// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/mesh.hpp"
#include "percolith/simulation/report.hpp"

namespace percolith::simulation {

/// Fills in counts, areas, edges and angles of a mesh, and warns of very sharp angles.
void describe_mesh(const mesh::Mesh& mesh, CheckReport& report);

}  // namespace percolith::simulation
