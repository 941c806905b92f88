// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/device.hpp"
#include "percolith/core/simd.hpp"

namespace percolith::seepage {

/// Pressure (Pa) and saturation of the fluid at a node.
template <class Real>
struct FluidState {
  Real pressure;
  Real saturation;
};

/// State equation of a pore or crack node (theory.md section 2; linearised in the paper's (24),
/// (31), (32)).
///
/// `excess` w (m2) is the fluid the node holds beyond a full node at the reference pressure in the
/// undeformed state; `growth` (m2) by how much its void space has grown since; `storage` S (m2/Pa)
/// is sum V0/M for pores and V/K_w for cracks; `void_volume` (m2) is sum phi V0, or V. With
/// d = w - growth the node is full when d >= 0 and its pressure is p_ref + d/S; otherwise it stays
/// at p_ref and its saturation is 1 + d/(void_volume + growth). Both are continuous at d = 0.
/// A node that cannot empty is always full.
template <class Real>
PERCOLITH_DEVICE FluidState<Real> fluid_state(Real excess, Real growth, Real storage,
                                              Real void_volume, double reference_pressure,
                                              bool can_empty) {
  const Real surplus = excess - growth;
  if (!can_empty) {
    return {reference_pressure + surplus / storage, Real(1.0)};
  }
  const auto full = surplus >= Real(0.0);
  return {reference_pressure + select(full, surplus, Real(0.0)) / storage,
          select(full, Real(1.0), Real(1.0) + surplus / (void_volume + growth))};
}

/// Inverse of the state equation: the excess of a node at pressure `pressure` when full
/// (saturation 1), else of a node at the reference pressure with that saturation.
PERCOLITH_DEVICE double excess_of(FluidState<double> state, double growth, double storage,
                                  double void_volume, double reference_pressure) {
  const double surplus = state.saturation < 1.0 ? (state.saturation - 1.0) * (void_volume + growth)
                                                : storage * (state.pressure - reference_pressure);
  return surplus + growth;
}

/// Weight of a flow that starts where the saturation is `s`, (17): s^2 (3 - 2 s). It vanishes with
/// the saturation, so that an empty node gives nothing away.
template <class Real>
PERCOLITH_DEVICE Real saturation_weight(Real s) {
  return s * s * (Real(3.0) - Real(2.0) * s);
}

}  // namespace percolith::seepage
