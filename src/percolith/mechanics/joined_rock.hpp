// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/joined_nodes.hpp"
#include "percolith/mechanics/soft_joints.hpp"

#include <memory>
#include <span>
#include <vector>

namespace percolith::mechanics {

/// How rock gives way as a whole (theory.md section 25): its triangles at small strains, joined
/// where joints are whole and held together by springs where they are soft.
class JoinedRock {
public:
  explicit JoinedRock(const Model& model);
  ~JoinedRock();
  JoinedRock(const JoinedRock&) = delete;
  JoinedRock& operator=(const JoinedRock&) = delete;

  /// Looks at the joints of the model; where they hold much more or much less than when last
  /// looked at, the stiffness is put together and factorised anew.
  void refresh(const Model& model);
  /// The next `refresh` looks as if it were the first: what follows depends on the model alone.
  void forget() { is_known_ = false; }

  /// The way (m; x and y in turn per corner slot) to the balance of the forces `pull` (N/m; the
  /// same order) as this rock has it. Supports hold, whole joints stay together, and parts that
  /// nothing holds keep their middle and their bearing. No way at all where the stiffness cannot be
  /// factorised.
  void find_way(const Model& model, std::span<const double> pull, std::span<double> way) const;

  /// The share of `way`, at most 1, on which no bond that softens opens or slips by more than half
  /// of the range over which it does.
  [[nodiscard]] double careful_share(const Model& model, std::span<const double> way) const;

  /// The share of `way`, at most 1, on which open faces overlap by no more than what the force
  /// `unbalanced` (N/m), if all joints that are not whole shared it, would press them into each
  /// other: the stiffness does not know of faces that are apart.
  [[nodiscard]] double share_to_meeting(const Model& model, std::span<const double> way,
                                        double unbalanced) const;

private:
  struct Factor;

  JointTable table_;
  bool is_known_ = false;
  std::vector<SoftJoint> soft_;
  JoinedNodes nodes_;
  std::unique_ptr<Factor> factor_;
};

}  // namespace percolith::mechanics
