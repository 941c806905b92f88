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
/// since it first went past its peak; all zero before.
template <class Real>
struct JointMemory {
  Real opening_peak;
  Real slip_peak;
  Real damage;
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

/// Traction of a point that may have gone past its peak, and its memory brought up to date (paper
/// section 2.4, (10); theory.md section 10):
///   o_p = f_t/k, s_p = (c + max(0, -t_n) tan(phi))/k,
///   D = max over time of sqrt(((o - o_p)/(o_r - o_p))^2 + ((|s| - s_p)/(s_r - s_p))^2), at most 1,
///   t_n = z(D) f_t o/max(o_max, o_p) for o > 0, k o otherwise,
///   t_s = (z(D) c + max(0, -t_n) tan(phi)) s/max(s_max, s_p).
/// The slip at the peak grows with compression, so that the slope before it is k whatever the
/// compression (docs/decisions/joint-shear-slope.md). Undamaged points get `elastic_traction` to
/// the bit.
template <class Real>
PERCOLITH_DEVICE JointTraction<Real> softening_traction(const JointConstants<Real>& c, Real opening,
                                                        Real slip, JointMemory<Real>& memory) {
  const JointTraction<Real> elastic = elastic_traction(c.stiffness, opening, slip);
  const Real friction = frictional_strength(c, elastic.normal);
  const Real opening_at_peak = c.tensile / c.stiffness;
  const Real slip_at_peak = (c.cohesion + friction) / c.stiffness;
  const Real slid = magnitude(slip);
  const Real past_opening = larger(Real(0.0), (opening - opening_at_peak) * c.opening_range);
  const Real past_slip = larger(Real(0.0), (slid - slip_at_peak) * c.slip_range);
  // Asked as `exceeds_strength` asks, so that a point below its strength is one in either form.
  const auto active = memory.damage > Real(0.0) || exceeds_strength(c, elastic);
  const Real reached =
      select(active, square_root(past_opening * past_opening + past_slip * past_slip), Real(0.0));
  memory.damage = smaller(Real(1.0), larger(memory.damage, reached));
  const auto damaged = memory.damage > Real(0.0);
  memory.opening_peak = select(damaged, larger(memory.opening_peak, opening), memory.opening_peak);
  memory.slip_peak = select(damaged, larger(memory.slip_peak, slid), memory.slip_peak);
  const Real left = softening(memory.damage);
  const Real tension = left * c.tensile / larger(memory.opening_peak, opening_at_peak) * opening;
  // Without cohesion and pressure the slip at the peak is zero too.
  const Real slip_reached = larger(larger(memory.slip_peak, slip_at_peak), Real(1e-300));
  const Real shear = (left * c.cohesion + friction) / slip_reached * slip;
  return {select(damaged && opening > Real(0.0), tension, elastic.normal),
          select(damaged, shear, elastic.shear)};
}

/// Energy (J/m2) that a point of the given damage gives back when it is unloaded along its secants.
/// Past the peak friction follows the compression at the same slip, which no energy of opening and
/// slip can: of a point that slides under compression only the spring counts.
template <class Real>
PERCOLITH_DEVICE Real stored_energy(const JointTraction<Real>& traction, Real opening, Real slip,
                                    Real stiffness, Real damage) {
  const auto slides = damage > Real(0.0) && traction.normal < Real(0.0);
  const Real spring = (traction.normal * traction.normal + traction.shear * traction.shear) /
                      select(slides, stiffness, Real(1.0));
  const Real secant = traction.normal * opening + traction.shear * slip;
  return Real(0.5) * select(slides, spring, secant);
}

/// The part of the shear traction (Pa) that is friction, of a point past its peak; 0 before.
template <class Real>
PERCOLITH_DEVICE Real friction_of(const JointConstants<Real>& c, Real opening, Real slip,
                                  const JointMemory<Real>& memory) {
  const Real friction = frictional_strength(c, c.stiffness * opening);
  const Real slip_at_peak = (c.cohesion + friction) / c.stiffness;
  const Real share = friction / larger(larger(memory.slip_peak, slip_at_peak), Real(1e-300)) * slip;
  return select(memory.damage > Real(0.0), share, Real(0.0));
}

/// A point as it was at an earlier moment.
template <class Real>
struct JointMoment {
  Real opening, slip;  ///< m
  JointTraction<Real> traction;
  Real damage;
};

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
  const Real slip_at_peak = (c.cohesion + friction) / c.stiffness;
  const Real opening = smaller(now.opening, c.tensile / c.stiffness);
  const Real slip = larger(smaller(now.slip, slip_at_peak), -slip_at_peak);
  return {opening, slip, elastic_traction(c.stiffness, opening, slip), Real(0.0)};
}

/// What a point lost from `before` to `now`: the work of its traction, by the trapezoidal rule,
/// less what is stored more; friction apart. `memory` is that of now. A point that was whole before
/// counts from its peak, up to which it lost nothing.
template <class Real>
PERCOLITH_DEVICE JointLoss<Real>
joint_loss(const JointConstants<Real>& c, const JointMoment<Real>& before,
           const JointMoment<Real>& now, const JointMemory<Real>& memory) {
  const auto known = before.damage > Real(0.0);
  const JointMoment<Real> peak = moment_at_peak(c, now);
  const JointMoment<Real> from{select(known, before.opening, peak.opening),
                               select(known, before.slip, peak.slip),
                               {select(known, before.traction.normal, peak.traction.normal),
                                select(known, before.traction.shear, peak.traction.shear)},
                               before.damage};
  const auto stored = [&](const JointMoment<Real>& moment) {
    return stored_energy(moment.traction, moment.opening, moment.slip, c.stiffness, moment.damage);
  };
  const Real slid = now.slip - from.slip;
  const Real work =
      Real(0.5) * ((from.traction.normal + now.traction.normal) * (now.opening - from.opening) +
                   (from.traction.shear + now.traction.shear) * slid);
  const Real friction = slid * friction_of(c, now.opening, now.slip, memory);
  const auto softens = memory.damage > Real(0.0);
  return {select(softens, work - (stored(now) - stored(from)) - friction, Real(0.0)),
          select(softens, friction, Real(0.0))};
}

}  // namespace percolith::material
