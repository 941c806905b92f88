// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/simd.hpp"
#include "percolith/core/vec2.hpp"
#include "percolith/material/joint_law.hpp"

#include <array>

// Opening, slip and forces of one joint (paper section 2.4; theory.md section 10).
namespace percolith::mechanics {

/// Weight of a joint's end 0 at integration point 0 or 1 (Gauss); that of end 1 at the other point.
PERCOLITH_DEVICE constexpr double gauss_weight(std::size_t point) {
  return point == 0 ? 0.78867513459481287 : 0.21132486540518713;
}

/// A joint as it lies: unit vectors along it from end 0 to end 1 and across it from side 0 to side
/// 1, and what side 1 has moved away from side 0 at both ends, m.
template <class Real>
struct JointPlace {
  Vec2<Real> along, across;
  std::array<Vec2<Real>, 2> apart;
};

/// From the undeformed edge (m) and the displacements of the four corners [side][end]. The corners
/// of an end lie on each other at first, so that `apart` is free of the coordinates. The joint
/// turns with the mean of its two faces.
template <class Real>
PERCOLITH_DEVICE JointPlace<Real> joint_place(Vec2<Real> edge,
                                              const std::array<std::array<Vec2<Real>, 2>, 2>& u) {
  const Vec2<Real> mean = edge + Real(0.5) * ((u[0][1] - u[0][0]) + (u[1][1] - u[1][0]));
  const Real scale = Real(1.0) / square_root(dot(mean, mean));
  const Vec2<Real> along = scale * mean;
  return {along, clockwise(along), {u[1][0] - u[0][0], u[1][1] - u[0][1]}};
}

/// What side 1 has moved away from side 0 at an integration point, m: across the joint is the
/// opening, along it the slip.
template <class Real>
PERCOLITH_DEVICE Vec2<Real> apart_at(const JointPlace<Real>& place, std::size_t point) {
  return Real(gauss_weight(point)) * place.apart[0] +
         Real(gauss_weight(1 - point)) * place.apart[1];
}

/// Forces (N/m) on side 0 at both ends, those on side 1 are opposite: the tractions at the two
/// points, each over half the undeformed length (m).
template <class Real>
PERCOLITH_DEVICE std::array<Vec2<Real>, 2>
joint_forces(const JointPlace<Real>& place, Real length,
             const std::array<material::JointTraction<Real>, 2>& t) {
  const Real half = Real(0.5) * length;
  std::array<Vec2<Real>, 2> at_point;
  for (std::size_t g = 0; g < 2; ++g) {
    at_point[g] = half * (t[g].normal * place.across + t[g].shear * place.along);
  }
  const Real near(gauss_weight(0));
  const Real far(gauss_weight(1));
  return {near * at_point[0] + far * at_point[1], far * at_point[0] + near * at_point[1]};
}

}  // namespace percolith::mechanics
