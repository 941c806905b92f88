// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace percolith::coupling {

/// Stiffness (N/m a m) with which the fluid of a crack node holds back a corner at a face of a
/// joint that ends there (theory.md, C5): k = 1/2 L (sum L) K_w/V. `length` L is that of the joint
/// and `all_lengths` the sum over all joints that end at the node, m; `bulk_modulus` K_w in Pa,
/// `volume` V of the node in m2. A corner that moves by d across its face makes room of 1/2 L d,
/// which changes the pressure by K_w/V times as much, and with it the forces 1/2 L_j on the two
/// faces of every joint j: k is the sum of their magnitudes, by which Gershgorin bounds the
/// frequency.
inline double fluid_stiffness(double length, double all_lengths, double bulk_modulus,
                              double volume) {
  return 0.5 * length * all_lengths * bulk_modulus / volume;
}

}  // namespace percolith::coupling
