// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/vec2.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace percolith::mesh {

/// A mesh as a file holds it: points, triangles, edges and points in named physical groups. It is
/// already free of points that no triangle uses; nothing else has been checked or derived.
/// Indices are 32 bits, from 0. Triangles may be listed clockwise or counter-clockwise.
struct GmshMesh {
  std::string file;                                    ///< for messages
  std::vector<Point> points;                           ///< m
  std::vector<std::array<std::int32_t, 3>> triangles;  ///< point indices
  std::vector<std::int32_t> triangle_region;           ///< index into `regions`
  std::vector<std::string> regions;                    ///< names of the physical surfaces
  /// Edges of each physical curve by name; an edge is in every group whose curves contain it.
  std::map<std::string, std::vector<std::array<std::int32_t, 2>>> curves;
  /// Points of each physical point group by name.
  std::map<std::string, std::vector<std::int32_t>> point_groups;
};

/// Hash of all but the file's name, for telling whether a mesh is still the same.
[[nodiscard]] std::string hash_of(const GmshMesh& mesh);

}  // namespace percolith::mesh
