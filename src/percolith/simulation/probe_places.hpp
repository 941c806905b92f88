// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/joint_finder.hpp"
#include "percolith/mesh/triangle_finder.hpp"
#include "percolith/simulation/setup.hpp"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace percolith::simulation {

/// A point of a probe, found in the matrix or on a crack.
struct ProbeTarget {
  Point place;
  mesh::PlaceInTriangle in_matrix;
  std::vector<mesh::PlaceOnJoint> in_crack;  ///< where a crack may pass, nearest first
};

/// The points of one probe.
struct LocatedProbe {
  std::string name;
  Domain in = Domain::matrix;
  std::vector<ProbeTarget> targets;
};

struct ProbePlaces {
  std::vector<LocatedProbe> probes;
  std::vector<std::string> warnings;
};

/// Finds the points of all probes in the mesh; `cracks` are the joints a probe in cracks may stand
/// on, those that may break in time among them: a point has all that are within half an edge.
/// Throws InputError (key `probe.NAME...`) for a point outside of the rock, or in a crack where
/// there is none so near. Points of a line in a crack that are farther away than that, and points
/// of a line outside of the rock, are left out with a warning; a line without any point is refused.
[[nodiscard]] ProbePlaces locate_probes(const std::map<std::string, Probe>& probes,
                                        const mesh::Mesh& mesh,
                                        std::span<const mesh::Index> cracks);

}  // namespace percolith::simulation
