// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/simd.hpp"

namespace percolith::material {

/// What one step of sliding made of a tangential force.
template <class Real>
struct FrictionStep {
  Real force{};  ///< N/m, after the step
  Real slip{};   ///< m, the part of the displacement that is not recovered; sign of the force
  Real loss{};   ///< J/m, dissipated: slip times the mean of the forces before and after
};

/// Coulomb friction with a tangential spring, (6), (7):
///
///     f' = f - k s,   |f'| <= limit
///
/// with f the force before (N/m), s the tangential displacement of the step (m, of the body the
/// force acts on, relative to the other), k > 0 the stiffness (Pa), limit = tan(phi) |f_n| (N/m).
/// The loss is what the work (f + f')/2 s took from the bodies and f'^2/(2 k) did not store.
template <class Real>
PERCOLITH_DEVICE FrictionStep<Real> friction_step(Real force, Real stiffness, Real displacement,
                                                  Real limit) {
  const Real trial = force - stiffness * displacement;
  FrictionStep<Real> step;
  step.force = select(trial > limit, limit, select(trial < -limit, -limit, trial));
  step.slip = (trial - step.force) / stiffness;
  step.loss = Real(0.5) * (force + step.force) * step.slip;
  return step;
}

}  // namespace percolith::material
