// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/simd.hpp"
#include "percolith/mechanics/contact/separation.hpp"

#include <array>

namespace percolith::mechanics {

/// What an edge meets of the potential of another triangle. Places along it are shares t of the
/// edge, 0 at its start and 1 at its end.
template <class Real>
struct EdgeLoad {
  Real start, end;  ///< the part within the other triangle; both 0 where there is none
  Real at_start;    ///< integral over t of (1 - t) min(lambda_1, lambda_2, lambda_3)
  Real at_end;      ///< integral over t of t min(lambda_1, lambda_2, lambda_3)
};

/// An area coordinate along an edge: value + slope t.
template <class Real>
struct Line {
  Real value, slope;
};

/// Exchanges two lines where the second one rises more steeply.
template <class Real>
PERCOLITH_DEVICE void steeper_first(Line<Real>& a, Line<Real>& b) {
  const auto exchange = a.slope < b.slope;
  const Line<Real> first{select(exchange, b.value, a.value), larger(a.slope, b.slope)};
  b = {select(exchange, a.value, b.value), smaller(a.slope, b.slope)};
  a = first;
}

/// A line integrated from t = `from` to `to`: added to the integral and to that of t times it.
template <class Real>
PERCOLITH_DEVICE void add_piece(const Line<Real>& line, Real from, Real to, Real& sum,
                                Real& moment) {
  const Real length = to - from;
  const Real middle = Real(0.5) * (from + to);
  const Real piece = length * (line.value + line.slope * middle);
  sum += piece;
  moment += piece * middle + Real(1.0 / 12.0) * line.slope * (length * length * length);
}

/// The lines of an edge by their slopes, and where they meet zero and each other. Two divisions
/// serve all; where two lines are parallel, one is taken to be steeper by a share far below
/// round-off.
template <class Real>
struct EdgeLines {
  Line<Real> rising, middle, falling;
  Real rising_zero, middle_zero, falling_zero;
  Real rising_middle, rising_falling, middle_falling;  ///< crossings

  /// From the coordinates where the edge starts and where it ends.
  PERCOLITH_DEVICE EdgeLines(const std::array<Real, 3>& first, const std::array<Real, 3>& last)
      : rising{first[0], last[0] - first[0]}, middle{first[1], last[1] - first[1]},
        falling{first[2], last[2] - first[2]} {
    steeper_first(rising, middle);
    steeper_first(middle, falling);
    steeper_first(rising, middle);
    // The slopes add up to zero: these three are neither zero nor much smaller than each other.
    const Real spread = rising.slope - falling.slope;
    const auto outer = inverses(rising.slope, -falling.slope, spread);
    rising_zero = -rising.value * outer[0];
    falling_zero = falling.value * outer[1];
    rising_falling = (falling.value - rising.value) * outer[2];
    const Real least = Real(1e-30) * spread;
    const auto inner =
        inverses(larger(magnitude(middle.slope), least), larger(rising.slope - middle.slope, least),
                 larger(middle.slope - falling.slope, least));
    middle_zero = middle.value * inner[0];
    rising_middle = (middle.value - rising.value) * inner[1];
    middle_falling = (falling.value - middle.value) * inner[2];
  }
};

/// Of an edge of a triangle, from the area coordinates of its ends in the other one. Exact but for
/// round-off: the smallest of three lines has up to three pieces, the rising one first, the falling
/// one last, that between them only where it is below their crossing.
template <class Real>
PERCOLITH_DEVICE EdgeLoad<Real> edge_load(const std::array<Real, 3>& first,
                                          const std::array<Real, 3>& last) {
  const EdgeLines<Real> line(first, last);
  const Real zero(0.0);
  const Real one(1.0);
  // A first argument that is no number loses.
  Real start = larger(line.rising_zero, zero);
  Real end = smaller(line.falling_zero, one);
  const auto falls = line.middle.slope < zero;
  start = select(falls, start, larger(-line.middle_zero, start));
  end = select(falls, smaller(line.middle_zero, end), end);
  const auto inside = start < end;
  start = select(inside, start, zero);
  end = select(inside, end, zero);
  const Real a = smaller(larger(smaller(line.rising_middle, line.rising_falling), start), end);
  const Real b = smaller(larger(larger(line.middle_falling, line.rising_falling), start), end);
  Real sum(0.0);
  Real moment(0.0);
  add_piece(line.rising, start, a, sum, moment);
  add_piece(line.middle, a, b, sum, moment);
  add_piece(line.falling, b, end, sum, moment);
  // Never negative, even where rounding left the triangle.
  sum = larger(sum, zero);
  moment = smaller(larger(moment, zero), sum);
  return {start, end, sum - moment, moment};
}

}  // namespace percolith::mechanics
