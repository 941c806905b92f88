// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/closed_joints.hpp"
#include "percolith/mechanics/joint_forces.hpp"
#include "percolith/mechanics/model.hpp"

#include <vector>

namespace percolith::mechanics {

/// How the law of a joint came to its end.
enum class Mode : std::int32_t { none = 0, tensile = 1, shear = 2, mixed = 3 };

/// A joint that broke.
struct Breakage {
  Index joint = 0;
  double time = 0.0;  ///< s
  Mode mode = Mode::none;
  double length = 0.0;    ///< m
  double released = 0.0;  ///< J/m: spent in its bond since its peak
};

/// What changed in a step.
struct Changes {
  std::vector<Breakage> broke;         ///< bonded joints that failed, ascending
  std::vector<ClosedJointEnd> parted;  ///< closed joints that contact takes over, ascending
  [[nodiscard]] bool any() const { return !broke.empty() || !parted.empty(); }
};

/// Gives up the bonded joints all of whose points have failed: those under compression become
/// closed joints, which keep their forces, the others broken ones; then gives up the closed joints
/// whose faces no longer face each other. Fans change at the two vertices of each joint only.
Changes break_failed_joints(Model& model, const JointTable& table);

/// Counts parts connected through tied or bonded joints.
struct Fragments {
  std::vector<Index> number;  ///< per triangle, from 0; `none` for triangles that were taken out
  std::vector<double> area;   ///< m2, undeformed, per fragment
};
[[nodiscard]] Fragments find_fragments(const Model& model);

}  // namespace percolith::mechanics
