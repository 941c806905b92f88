// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/simd.hpp"
#include "percolith/material/softening.hpp"

namespace percolith::material {

/// Traction (Pa) across and along a joint; tension positive.
template <class Real>
struct JointTraction {
  Real normal;
  Real shear;
};

/// What a point of a bonded joint remembers: the largest opening and slip (m) and the damage D
/// since it first went past its peak, and of its last step the slope of cohesion over slip (Pa/m),
/// the friction (Pa) and the slip (m); all zero before.
template <class Real>
struct JointMemory {
  Real opening_peak;
  Real slip_peak;
  Real damage;
  Real slope;
  Real friction;
  Real slip;
};

/// Constants of the law at a joint. Reciprocals of the ranges of softening are kept, because a
/// broken joint has stiffness 0 and then no term divides zero by zero.
template <class Real>
struct JointConstants {
  Real stiffness;      ///< k = p_f/h, Pa/m
  Real tensile;        ///< f_t, Pa
  Real cohesion;       ///< c, Pa
  Real friction;       ///< tan(phi)
  Real opening_range;  ///< 1/(o_r - o_p) = 0.36309 f_t/G_I, 1/m
  Real slip_range;     ///< 1/(s_r - s_p) = 0.36309 c/G_II, 1/m
};

/// Traction before the peak: k times opening and slip (m), in tension and compression alike.
template <class Real>
PERCOLITH_DEVICE JointTraction<Real> elastic_traction(Real stiffness, Real opening, Real slip) {
  return {stiffness * opening, stiffness * slip};
}

/// Shear strength that friction adds under compression, max(0, -t_n) tan(phi), Pa.
template <class Real>
PERCOLITH_DEVICE Real frictional_strength(const JointConstants<Real>& c, Real normal) {
  return larger(Real(0.0), -normal) * c.friction;
}

/// Whether an undamaged point exceeds its strength under its elastic traction: t_n > f_t or
/// |t_s| > c + max(0, -t_n) tan(phi).
template <class Real>
PERCOLITH_DEVICE auto exceeds_strength(const JointConstants<Real>& c,
                                       const JointTraction<Real>& elastic) {
  return elastic.normal > c.tensile ||
         magnitude(elastic.shear) > c.cohesion + frictional_strength(c, elastic.normal);
}

/// A value within [-limit, limit].
template <class Real>
PERCOLITH_DEVICE Real within(Real value, Real limit) {
  return larger(smaller(value, limit), -limit);
}

/// Share of the shear traction that friction bears where a whole point reaches its peak.
template <class Real>
PERCOLITH_DEVICE Real friction_share(const JointConstants<Real>& c, Real friction) {
  return friction / larger(c.cohesion + friction, Real(1e-300));
}

/// Traction of a point that may have gone past its peak, and its memory brought up to date (paper
/// section 2.4, (10); theory.md section 10), with r = max(0, -t_n) tan(phi):
///   o_p = f_t/k, s_p = (c + r)/k,
///   D = max over time of sqrt(((o - o_p)/(o_r - o_p))^2 + ((|s| - s_p)/(s_r - s_p))^2), at most 1,
///   t_n = z(D) f_t o/max(o_max, o_p) for o > 0, k o otherwise,
///   t_s = K s + t_f, K = min over time of z(D) c/max(s_max, s_p),
///   t_f <- t_f + (k - K) ds, cut to |t_f| <= r.
/// Cohesion softens and unloads along its secant, friction beside it is that of Coulomb, with a
/// spring that makes the slope of both together k (docs/decisions/joint-shear-slope.md). On a way
/// that never turns back t_s past the peak is z(D) c + r. Undamaged points get `elastic_traction`
/// to the bit.
template <class Real>
PERCOLITH_DEVICE JointTraction<Real> softening_traction(const JointConstants<Real>& c, Real opening,
                                                        Real slip, JointMemory<Real>& memory) {
  const Real zero(0.0);
  const JointTraction<Real> elastic = elastic_traction(c.stiffness, opening, slip);
  const Real friction = frictional_strength(c, elastic.normal);
  const Real opening_at_peak = c.tensile / c.stiffness;
  const Real slip_at_peak = (c.cohesion + friction) / c.stiffness;
  const Real slid = magnitude(slip);
  const Real past_opening = larger(zero, (opening - opening_at_peak) * c.opening_range);
  const Real past_slip = larger(zero, (slid - slip_at_peak) * c.slip_range);
  // Asked as `exceeds_strength` asks, so that a point below its strength is one in either form.
  const auto known = memory.damage > zero;
  const auto active = known || exceeds_strength(c, elastic);
  const Real reached =
      select(active, square_root(past_opening * past_opening + past_slip * past_slip), zero);
  memory.damage = smaller(Real(1.0), larger(memory.damage, reached));
  const auto damaged = memory.damage > zero;
  memory.opening_peak = select(damaged, larger(memory.opening_peak, opening), memory.opening_peak);
  memory.slip_peak = select(damaged, larger(memory.slip_peak, slid), memory.slip_peak);
  const Real left = softening(memory.damage);
  const Real tension = left * c.tensile / larger(memory.opening_peak, opening_at_peak) * opening;
  // Without cohesion and pressure the slip at the peak is zero too.
  const Real slip_reached = larger(larger(memory.slip_peak, slip_at_peak), Real(1e-300));
  const Real slope = left * c.cohesion / slip_reached;
  memory.slope = select(damaged, select(known, smaller(slope, memory.slope), slope), zero);
  const Real slip_before = select(known, memory.slip, within(slip, slip_at_peak));
  const Real rubbing =
      select(known, memory.friction, friction_share(c, friction) * c.stiffness * slip_before);
  const Real grip = larger(zero, c.stiffness - memory.slope);
  memory.friction = select(damaged, within(rubbing + grip * (slip - slip_before), friction), zero);
  memory.slip = select(damaged, slip, zero);
  return {select(damaged && opening > zero, tension, elastic.normal),
          select(damaged, memory.slope * slip + memory.friction, elastic.shear)};
}

/// A point at one moment.
template <class Real>
struct JointMoment {
  Real opening, slip;  ///< m
  JointTraction<Real> traction;
  Real slope;     ///< of cohesion over slip, Pa/m; k of a point that is whole
  Real friction;  ///< part of the shear traction, Pa
  Real damage;
};

/// The moment of a point with the traction and the memory that `softening_traction` gave.
template <class Real>
PERCOLITH_DEVICE JointMoment<Real> moment_of(const JointConstants<Real>& c, Real opening, Real slip,
                                             const JointTraction<Real>& traction,
                                             const JointMemory<Real>& memory) {
  const auto damaged = memory.damage > Real(0.0);
  return {opening,         slip,         traction, select(damaged, memory.slope, c.stiffness),
          memory.friction, memory.damage};
}

/// Energy in the spring of friction, J/m2.
template <class Real>
PERCOLITH_DEVICE Real friction_energy(const JointConstants<Real>& c, const JointMoment<Real>& m) {
  const Real grip = c.stiffness - m.slope;
  const auto grips = grip > Real(0.0);
  return select(grips, Real(0.5) * m.friction * m.friction / select(grips, grip, Real(1.0)),
                Real(0.0));
}

/// Energy (J/m2) that a point gives back when it is unloaded along its secants.
template <class Real>
PERCOLITH_DEVICE Real stored_energy(const JointConstants<Real>& c, const JointMoment<Real>& m) {
  return Real(0.5) * (m.traction.normal * m.opening + m.slope * m.slip * m.slip) +
         friction_energy(c, m);
}

/// Energies that a point lost between two moments, J/m2.
template <class Real>
struct JointLoss {
  Real bond, friction;
};

/// Where the straight way of a point from rest to its present opening and slip passed its peak: the
/// part of each that its strength bears at the present compression.
template <class Real>
PERCOLITH_DEVICE JointMoment<Real> moment_at_peak(const JointConstants<Real>& c,
                                                  const JointMoment<Real>& now) {
  const Real friction = frictional_strength(c, c.stiffness * now.opening);
  const Real opening = smaller(now.opening, c.tensile / c.stiffness);
  const Real slip = within(now.slip, (c.cohesion + friction) / c.stiffness);
  const JointTraction<Real> elastic = elastic_traction(c.stiffness, opening, slip);
  const Real share = friction_share(c, friction);
  return {opening,  slip, elastic, c.stiffness * (Real(1.0) - share), share * elastic.shear,
          Real(0.0)};
}

/// What a point lost from `before` to `now`: the work of its traction, by the trapezoidal rule,
/// less what is stored more; friction apart. A point that was whole before counts from its peak, up
/// to which it lost nothing.
template <class Real>
PERCOLITH_DEVICE JointLoss<Real> joint_loss(const JointConstants<Real>& c,
                                            const JointMoment<Real>& before,
                                            const JointMoment<Real>& now) {
  const auto known = before.damage > Real(0.0);
  const JointMoment<Real> peak = moment_at_peak(c, now);
  const JointMoment<Real> from{select(known, before.opening, peak.opening),
                               select(known, before.slip, peak.slip),
                               {select(known, before.traction.normal, peak.traction.normal),
                                select(known, before.traction.shear, peak.traction.shear)},
                               select(known, before.slope, peak.slope),
                               select(known, before.friction, peak.friction),
                               before.damage};
  const Real half(0.5);
  const Real slid = now.slip - from.slip;
  const Real work =
      half * ((from.traction.normal + now.traction.normal) * (now.opening - from.opening) +
              (from.traction.shear + now.traction.shear) * slid);
  const Real all = work - (stored_energy(c, now) - stored_energy(c, from));
  const Real friction = half * (from.friction + now.friction) * slid -
                        (friction_energy(c, now) - friction_energy(c, from));
  const auto softens = now.damage > Real(0.0);
  return {select(softens, all - friction, Real(0.0)), select(softens, friction, Real(0.0))};
}

}  // namespace percolith::material
