// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/joint_reader.hpp"

#include <array>
#include <vector>

namespace percolith::mechanics {

/// What a joint that is not whole holds its faces together with.
struct SoftJoint {
  Index joint = 0;
  std::array<double, 2> normal{}, shear{};  ///< Pa/m, at the integration points
  Point along{}, across{};                  ///< unit vectors in the present place
};

/// Whether a joint is there and its faces stay together: tied, rigid, or bonded and undamaged.
[[nodiscard]] bool is_whole(const Model& model, Index joint);

/// The joints between triangles that are there of which `is_whole` is not true, ascending: bonds
/// that soften with the secants of their law, which are stiffer than its tangents; faces that press
/// on each other with the stiffness they were bonded with; open ones with none.
[[nodiscard]] std::vector<SoftJoint> soft_joints(const Model& model, const JointTable& table);

/// Whether both are the same joints and hold about as much, to a quarter.
[[nodiscard]] bool about_the_same(const std::vector<SoftJoint>& a, const std::vector<SoftJoint>& b);

}  // namespace percolith::mechanics
