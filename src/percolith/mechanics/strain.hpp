// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/model.hpp"
#include "percolith/mechanics/triangle.hpp"

namespace percolith::mechanics {

/// How one triangle is deformed.
struct TriangleStrain {
  Gradient<double> gradient;  ///< H
  Tensor strain;              ///< Green strain
};
/// `back` (s): where the corners were so long ago, at their present velocities.
[[nodiscard]] TriangleStrain triangle_strain(const Model& model, Index triangle, double back = 0.0);

/// Stress of a triangle without its viscous part: Cauchy stress in the plane, and across it, Pa.
struct TriangleStress {
  Tensor plane;
  double across = 0.0;
};
[[nodiscard]] TriangleStress triangle_stress(const Model& model, Index triangle);

/// Principal values, the more tensile first, and the unit vector of the first.
struct Principal {
  double first = 0.0, second = 0.0;
  Point direction{1.0, 0.0};
};
[[nodiscard]] Principal principal(const Tensor& stress);

}  // namespace percolith::mechanics
