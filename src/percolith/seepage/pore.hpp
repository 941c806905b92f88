// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/tensor2.hpp"
#include "percolith/core/vec2.hpp"

#include <array>

// Pore flow in one triangle and across one unbroken joint (theory.md section 3 and 4).
namespace percolith::seepage {

/// Conductances (m3/(s Pa) per metre: m2/(Pa s)) of a triangle with counter-clockwise points `p`
/// (m), permeability `k` (m2) and viscosity `mu` (Pa s): entry i belongs to the pair of corners i
/// and i+1, and c (phi_j - phi_i) flows from j to i, phi = p + rho_w g y. Summed over the pairs
/// this is the inflow -1/2 q.n L of (19) with the constant Darcy flux of (11), (14), (16):
/// c_ij = -(n_i L_i . k n_j L_j)/(4 A mu). It is negative opposite an obtuse angle.
PERCOLITH_DEVICE std::array<double, 3> pair_conductances(const std::array<Point, 3>& p,
                                                         const Tensor& k, double mu) {
  const std::array<Point, 3> normal{clockwise(p[2] - p[1]), clockwise(p[0] - p[2]),
                                    clockwise(p[1] - p[0])};
  const double area = 0.5 * cross(p[1] - p[0], p[2] - p[0]);
  const double factor = -1.0 / (4.0 * area * mu);
  return {factor * dot(normal[0], k * normal[1]), factor * dot(normal[1], k * normal[2]),
          factor * dot(normal[2], k * normal[0])};
}

/// Darcy flux (m/s), (11), (18), of a triangle from its three pair flows (m2/s): `flow[i]` runs
/// from corner i to corner i+1. Since the sum of c_ij (phi_i - phi_j) (x_j - x_i) over the pairs is
/// -(A/mu) k grad phi, this is the flux those flows carry, saturation weights included.
PERCOLITH_DEVICE Point darcy_flux(const std::array<Point, 3>& p,
                                  const std::array<double, 3>& flow) {
  const double area = 0.5 * cross(p[1] - p[0], p[2] - p[0]);
  return (1.0 / area) *
         (flow[0] * (p[1] - p[0]) + flow[1] * (p[2] - p[1]) + flow[2] * (p[0] - p[2]));
}

/// Exchange coefficient h_j = n k/(mu L_e) of an unbroken finite joint (m/(Pa s)); the two sides,
/// each with its permeability normal to the joint (m2) and its element size (m), act in series.
PERCOLITH_DEVICE double joint_exchange(double n, double k_first, double size_first, double k_second,
                                       double size_second, double mu) {
  const double first = n * k_first / (mu * size_first);
  const double second = n * k_second / (mu * size_second);
  return 2.0 * first * second / (first + second);
}

}  // namespace percolith::seepage
