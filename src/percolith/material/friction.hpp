// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/simd.hpp"

namespace percolith::material {

/// Friction after a step: the force, and the energy that sliding spent.
template <class Real>
struct Friction {
  Real force;
  Real dissipated;
};

/// Coulomb friction with memory, (6), (7): `trial` (N/m) is the force had the faces stuck, k
/// (N/m2) the stiffness it grew with, `limit` (N/m) what friction bears. The force is cut to the
/// limit; what is cut off was slip at the limit.
template <class Real>
PERCOLITH_DEVICE Friction<Real> coulomb_friction(Real trial, Real stiffness, Real limit) {
  const Real size = magnitude(trial);
  const Real kept = smaller(size, limit);
  const Real slip = select(stiffness > Real(0.0), (size - kept) / stiffness, Real(0.0));
  return {select(trial < Real(0.0), -kept, kept), kept * slip};
}

}  // namespace percolith::material
