// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/soft_joints.hpp"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace percolith::mechanics {

/// Corners that whole joints keep together, as one node each, and how supports let nodes move.
struct JoinedNodes {
  Index count = 0;
  std::vector<Index> of_corner;       ///< per corner slot; `none` for what was taken out
  std::vector<Eigen::Matrix2d> free;  ///< per node: projection on the directions left to it
  std::vector<Index> loose_part;      ///< per node: its part of the rock where nothing holds that
  Index loose_parts = 0;
};

/// From the present joints and supports of the model; `soft` are its soft joints. Where corners of
/// a node are held along different directions, the node is held along all.
[[nodiscard]] JoinedNodes joined_nodes(const Model& model, const std::vector<SoftJoint>& soft);

/// Takes out of a way (m, x and y in turn per corner slot) what moves and turns loose parts as a
/// whole.
void keep_loose_parts(const Model& model, const JoinedNodes& nodes, std::span<double> way);

}  // namespace percolith::mechanics
