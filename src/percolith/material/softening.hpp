// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/device.hpp"

namespace percolith::material {

/// Integral of `softening` from 0 to 1.
inline constexpr double softening_integral = 0.363086552408989;

/// Share z of the strength that is left at damage D in [0, 1] (theory.md section 10; Munjiza's
/// curve with a = 0.63, b = 1.8, c = 6): z = (1 - (a+b-1)/(a+b) exp(-r D)) (a (1-D) + b (1-D)^c)
/// with r = c b/((a+b)(a+b-1)) - a. z(0) = 1, z(1) = 0. The exponential is a polynomial of degree
/// nine in D/8 to the eighth power, exact to 1e-11: a library's would be called lane by lane.
template <class Real>
PERCOLITH_DEVICE Real softening(Real damage) {
  constexpr double a = 0.63;
  constexpr double b = 1.8;
  constexpr double rate = 6.0 * b / ((a + b) * (a + b - 1.0)) - a;
  const Real x = Real(-rate / 8.0) * damage;
  Real e = Real(1.0) + x * Real(1.0 / 9.0);
  for (int n = 8; n > 0; --n) {
    e = Real(1.0) + e * x * Real(1.0 / n);
  }
  e = e * e;
  e = e * e;
  e = e * e;
  const Real rest = Real(1.0) - damage;
  const Real cube = rest * rest * rest;
  return (Real(1.0) - Real((a + b - 1.0) / (a + b)) * e) * (Real(a) * rest + Real(b) * cube * cube);
}

}  // namespace percolith::material
