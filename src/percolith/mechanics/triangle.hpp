// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/tensor2.hpp"
#include "percolith/core/vec2.hpp"
#include "percolith/material/elasticity.hpp"

#include <array>

// Strain and forces of one constant-strain triangle at large rotation (paper (8), (9); theory.md
// section 8). Corners 0, 1, 2 run counter-clockwise.
namespace percolith::mechanics {

/// An undeformed triangle: edges a from corner 0 to 1 and b from 0 to 2 (m), and 1/(2 A), 1/m2.
template <class Real>
struct TriangleShape {
  Vec2<Real> a, b;
  Real inverse_double_area;
};

template <class Real>
PERCOLITH_DEVICE TriangleShape<Real> triangle_shape(Vec2<Real> a, Vec2<Real> b) {
  return {a, b, Real(1.0) / cross(a, b)};
}

/// Gradient of a field over the undeformed triangle: columns d/dx and d/dy.
template <class Real>
struct Gradient {
  Vec2<Real> x, y;
};

/// From the differences of the field from corner 0 to corners 1 and 2.
template <class Real>
PERCOLITH_DEVICE Gradient<Real> gradient_of(const TriangleShape<Real>& t, Vec2<Real> to_1,
                                            Vec2<Real> to_2) {
  const Real s = t.inverse_double_area;
  return {{s * (t.b.y * to_1.x - t.a.y * to_2.x), s * (t.b.y * to_1.y - t.a.y * to_2.y)},
          {s * (t.a.x * to_2.x - t.b.x * to_1.x), s * (t.a.x * to_2.y - t.b.x * to_1.y)}};
}

/// Green strain E = (H + H^T + H^T H)/2 of the displacement gradient H. Formed from H, so that
/// small strains keep their digits; exactly zero for a rigid motion but for round-off.
template <class Real>
PERCOLITH_DEVICE SymmetricTensor2<Real> green_strain(const Gradient<Real>& h) {
  return {h.x.x + Real(0.5) * dot(h.x, h.x), h.y.y + Real(0.5) * dot(h.y, h.y),
          Real(0.5) * ((h.y.x + h.x.y) + dot(h.x, h.y))};
}

/// Rate of the Green strain, the symmetric part of F^T Fdot, from H and the velocity gradient;
/// where rotations are large the rate of strain D of (8) in the axes of the material.
template <class Real>
PERCOLITH_DEVICE SymmetricTensor2<Real> green_strain_rate(const Gradient<Real>& h,
                                                          const Gradient<Real>& rate) {
  return {rate.x.x + dot(h.x, rate.x), rate.y.y + dot(h.y, rate.y),
          Real(0.5) * ((rate.y.x + rate.x.y) + (dot(h.x, rate.y) + dot(h.y, rate.x)))};
}

/// Forces (N/m) on the three corners.
template <class Real>
using CornerForces = std::array<Vec2<Real>, 3>;

/// Forces of a second Piola-Kirchhoff stress S, (9) in the undeformed state: f_i = 1/2 F S N_i with
/// N_i the outward normal times length of the undeformed edge opposite corner i.
template <class Real>
PERCOLITH_DEVICE CornerForces<Real> corner_forces(const TriangleShape<Real>& t,
                                                  const Gradient<Real>& h,
                                                  const SymmetricTensor2<Real>& s) {
  // Columns of P = F S with F = I + H.
  const Vec2<Real> px{s.xx + (h.x.x * s.xx + h.y.x * s.xy), s.xy + (h.x.y * s.xx + h.y.y * s.xy)};
  const Vec2<Real> py{s.xy + (h.x.x * s.xy + h.y.x * s.yy), s.yy + (h.x.y * s.xy + h.y.y * s.yy)};
  const Real half(0.5);
  // N_1 = clockwise(-b), N_2 = clockwise(a).
  const Vec2<Real> f1 = half * (t.b.x * py - t.b.y * px);
  const Vec2<Real> f2 = half * (t.a.y * px - t.a.x * py);
  return {Vec2<Real>{-(f1.x + f2.x), -(f1.y + f2.y)}, f1, f2};
}

/// Forces of a pressure (Pa) inside a triangle with the present edges `a` and `b` (m) on its
/// corners, (40): the pressure times the derivative of the area to the place of each corner.
template <class Real>
PERCOLITH_DEVICE CornerForces<Real> pressure_forces(Vec2<Real> a, Vec2<Real> b, Real pressure) {
  const Real half = Real(0.5) * pressure;
  const Vec2<Real> f1 = half * clockwise(b);
  const Vec2<Real> f2 = -half * clockwise(a);
  return {Vec2<Real>{-(f1.x + f2.x), -(f1.y + f2.y)}, f1, f2};
}

/// Growth of the area (m2) of a triangle with undeformed edges `a` and `b` whose corners 1 and 2
/// have moved by `to_1` and `to_2` against corner 0 (m); free of the loss of digits that the
/// difference of two areas has.
template <class Real>
PERCOLITH_DEVICE Real area_growth(Vec2<Real> a, Vec2<Real> b, Vec2<Real> to_1, Vec2<Real> to_2) {
  return Real(0.5) * ((cross(a, to_2) + cross(to_1, b)) + cross(to_1, to_2));
}

/// Cauchy stress F S F^T/det F of a second Piola-Kirchhoff stress S, Pa.
PERCOLITH_DEVICE Tensor cauchy_stress(const Gradient<double>& h, const Tensor& s) {
  const double fxx = 1.0 + h.x.x;
  const double fyy = 1.0 + h.y.y;
  const Point px{fxx * s.xx + h.y.x * s.xy, h.x.y * s.xx + fyy * s.xy};
  const Point py{fxx * s.xy + h.y.x * s.yy, h.x.y * s.xy + fyy * s.yy};
  const double scale = 1.0 / (fxx * fyy - h.y.x * h.x.y);
  return {scale * (px.x * fxx + py.x * h.y.x), scale * (px.y * h.x.y + py.y * fyy),
          scale * (px.x * h.x.y + py.x * fyy)};
}

}  // namespace percolith::mechanics
