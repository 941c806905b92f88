// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/seepage/model.hpp"

#include <cstdint>

namespace percolith::bench {

/// A fractured square metre of rock between 2 MPa on the left and 1 MPa on the right.
struct FlowCase {
  seepage::PoreJoints joints = seepage::PoreJoints::tied;
  double gravity = 9.81;      ///< m/s2
  bool partly_empty = false;  ///< half full at the start
  bool fractured = true;      ///< a network of crossing fractures is broken
  double aperture = 2e-5;     ///< m, of the fractures
  double exchange = 1e-8;     ///< m/(Pa s), of the fractures
};

/// The mesh of such cases, of about `triangles` triangles.
[[nodiscard]] mesh::Mesh make_flow_mesh(std::int32_t triangles);
/// All pores and cracks start full, at the pressure of the right side, or half full.
[[nodiscard]] seepage::Model make_flow_model(const mesh::Mesh& mesh, const FlowCase& flow);

}  // namespace percolith::bench
