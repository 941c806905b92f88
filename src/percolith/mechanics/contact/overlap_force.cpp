// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/contact/overlap_force.hpp"

#include "percolith/core/index.hpp"

#include <experimental/simd>

#include <algorithm>
#include <cmath>
#include <limits>

namespace percolith::mechanics {
namespace {

constexpr std::size_t next(std::size_t k) {
  return k == 2 ? 0 : k + 1;
}

bool has_beyond(const Corners& triangle, std::size_t edge, const Corners& other) {
  return beside_edge(triangle, edge, other[0]) <= 0.0 &&
         beside_edge(triangle, edge, other[1]) <= 0.0 &&
         beside_edge(triangle, edge, other[2]) <= 0.0;
}

bool parts(const PlacedPair& pair, std::size_t edge) {
  return edge < 3 ? has_beyond(pair.first, edge, pair.second)
                  : has_beyond(pair.second, edge - 3, pair.first);
}

using Row = EdgeParts::Row;

using Real = VectorLane::Real;

// A second argument that is no number loses.
inline Real lower(Real a, Real b) {
  return select(b < a, b, a);
}
inline Real upper(Real a, Real b) {
  return select(a < b, b, a);
}

/// Area coordinates in the other triangle at both ends of each edge, [coordinate][edge].
struct Coordinates {
  alignas(64) std::array<Row, 3> first, last;
};

/// Integrals along each edge, over the share t of it: 2/3 of that of the potential of the other
/// triangle, and twice that of the potential times t.
struct Loads {
  alignas(64) Row sum, moment;
};

/// Area coordinates along edges: lambda_i = value_i + slope_i t, 0 <= t <= 1.
struct Lambda {
  std::array<Real, 3> value, slope;
  /// A third of the potential phi; never negative, even where rounding left the triangle.
  [[nodiscard]] Real smallest(Real t) const {
    const Real a = value[0] + slope[0] * t;
    const Real b = value[1] + slope[1] * t;
    const Real c = value[2] + slope[2] * t;
    return upper(Real{}, lower(a, lower(b, c)));
  }
};

/// From 0 to 1 a whole edge.
struct Part {
  Real start, end;
};

/// The part where a coordinate, given at both ends, is not negative. A quotient by zero is not
/// used.
inline Part clip(Part part, Real first, Real last) {
  const Real zero = first / (first - last);
  const Real end = select(last < Real{}, lower(part.end, zero), part.end);
  return {select(first < Real{}, upper(part.start, zero), part.start),
          select(upper(first, last) <= Real{}, Real{}, end)};
}

/// Where two coordinates are equal, kept within the part.
inline Real crossing(const Lambda& lambda, std::size_t i, std::size_t j, const Part& part) {
  const Real t = (lambda.value[j] - lambda.value[i]) / (lambda.slope[i] - lambda.slope[j]);
  return upper(part.start, lower(part.end, t));
}

/// Adds the pieces between the places where another coordinate becomes the smallest: on each the
/// potential is linear. Gives 2/3 of the integral and 2 of the moment.
inline void integrate(const Lambda& lambda, const Part& part, Real& sum, Real& moment) {
  const Real a = crossing(lambda, 0, 1, part);
  const Real b = crossing(lambda, 0, 2, part);
  const Real c = crossing(lambda, 1, 2, part);
  const Real low = lower(a, b);
  const Real high = upper(a, b);
  const std::array<Real, 5> t{part.start, lower(low, c), upper(low, lower(high, c)), upper(high, c),
                              part.end};
  sum = Real{};
  moment = Real{};
  Real before = lambda.smallest(t[0]);
  for (std::size_t k = 1; k < t.size(); ++k) {
    const Real now = lambda.smallest(t[k]);
    const Real length = t[k] - t[k - 1];
    const Real both = before + now;
    sum += length * both;
    moment += length * (t[k - 1] * (both + before) + t[k] * (both + now));
    before = now;
  }
}

Loads integrate_edges(const Coordinates& coordinates, EdgeParts& rim) {
  constexpr Row whole{1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
  Loads loads;
  for (std::size_t e = 0; e < block_width; e += at(VectorLane::width)) {
    Lambda lambda;
    Part part{Real{}, VectorLane::load(&whole[e])};
    for (std::size_t i = 0; i < 3; ++i) {
      const Real first = VectorLane::load(&coordinates.first[i][e]);
      const Real last = VectorLane::load(&coordinates.last[i][e]);
      lambda.value[i] = first;
      lambda.slope[i] = last - first;
      part = clip(part, first, last);
    }
    const auto inside = part.start < part.end;
    part = {select(inside, part.start, Real{}), select(inside, part.end, Real{})};
    Real sum;
    Real moment;
    integrate(lambda, part, sum, moment);
    VectorLane::store(&rim.start[e], part.start);
    VectorLane::store(&rim.end[e], part.end);
    VectorLane::store(&loads.sum[e], sum);
    VectorLane::store(&loads.moment[e], moment);
  }
  return loads;
}

/// Enters the edges of triangle `own`, the first of them in place `place`.
void set_edges(const Corners& own, const Corners& other, std::size_t place,
               Coordinates& coordinates, EdgeParts& rim) {
  const double inverse = 1.0 / cross(other[1] - other[0], other[2] - other[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    rim.x[place + k] = own[k].x;
    rim.y[place + k] = own[k].y;
    rim.dx[place + k] = own[next(k)].x - own[k].x;
    rim.dy[place + k] = own[next(k)].y - own[k].y;
    for (std::size_t i = 0; i < 3; ++i) {
      const double lambda = inverse * beside_edge(other, next(i), own[k]);
      coordinates.first[i][place + k] = lambda;
      coordinates.last[i][place + (k == 0 ? 2 : k - 1)] = lambda;
    }
  }
}

/// Empties the places that hold no edge.
void clear_rest(Coordinates& coordinates, EdgeParts& rim) {
  for (std::size_t e = 6; e < block_width; ++e) {
    rim.x[e] = rim.y[e] = rim.dx[e] = rim.dy[e] = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      coordinates.first[i][e] = coordinates.last[i][e] = 0.0;
    }
  }
}

/// A force and its weight at the centre of pressure; four numbers fill a register.
struct alignas(32) Push {
  std::array<double, 4> value{};
  void add(double share, const Push& push) {
    for (std::size_t i = 0; i < 4; ++i) {
      value[i] += share * push.value[i];
    }
  }
};

using CornerPushes = std::array<Push, 3>;

/// What the edges from place `first` on carry, on the corners of their own triangle and of the
/// other one, whose penalty is given.
std::array<CornerPushes, 2> edge_pushes(const EdgeParts& rim, const Coordinates& coordinates,
                                        const Loads& loads, double penalty, std::size_t first) {
  CornerPushes own;
  CornerPushes other;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t e = first + k;
    const double x = -penalty * rim.dy[e];
    const double y = penalty * rim.dx[e];
    const double weight = std::sqrt(x * x + y * y);
    const Push on_own{{x, y, weight, 0.0}};
    const Push on_other{{-x, -y, weight, 0.0}};
    const double at_end = 0.5 * loads.moment[e];
    const double at_start = 1.5 * loads.sum[e] - at_end;
    own[k].add(at_start, on_own);
    own[next(k)].add(at_end, on_own);
    for (std::size_t i = 0; i < 3; ++i) {
      other[i].add(coordinates.first[i][e] * at_start + coordinates.last[i][e] * at_end, on_other);
    }
  }
  return {own, other};
}

}  // namespace

bool separated(const PlacedPair& pair, std::uint8_t& edge) {
  if (parts(pair, edge)) {
    return true;
  }
  for (std::uint8_t e = 0; e < 6; ++e) {
    if (e != edge && parts(pair, e)) {
      edge = e;
      return true;
    }
  }
  return false;
}

OverlapForce overlap_force(const PlacedPair& pair, const std::array<double, 2>& penalty) {
  OverlapForce result;
  Coordinates coordinates;
  set_edges(pair.first, pair.second, 0, coordinates, result.rim);
  set_edges(pair.second, pair.first, 3, coordinates, result.rim);
  clear_rest(coordinates, result.rim);
  const Loads loads = integrate_edges(coordinates, result.rim);
  const auto from_first = edge_pushes(result.rim, coordinates, loads, penalty[1], 0);
  const auto from_second = edge_pushes(result.rim, coordinates, loads, penalty[0], 3);
  for (std::size_t side = 0; side < 2; ++side) {
    CornerPushes p = from_first[side];
    for (std::size_t k = 0; k < 3; ++k) {
      p[k].add(1.0, from_second[1 - side][k]);
    }
    const double sum = p[0].value[2] + p[1].value[2] + p[2].value[2];
    const double inverse = sum > 0.0 ? 1.0 / sum : 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      result.on[side][k] = {p[k].value[0], p[k].value[1]};
      result.centre[side][k] = inverse * p[k].value[2];
    }
  }
  result.total = result.on[0][0] + result.on[0][1] + result.on[0][2];
  return result;
}

double extent_along(const OverlapForce& overlap, const Point& direction) {
  constexpr double far = std::numeric_limits<double>::infinity();
  const EdgeParts& rim = overlap.rim;
  Real low(far);
  Real high(-far);
  for (std::size_t e = 0; e < block_width; e += at(VectorLane::width)) {
    const auto along = [&](const Row& x, const Row& y) {
      return Real(direction.x) * VectorLane::load(&x[e]) +
             Real(direction.y) * VectorLane::load(&y[e]);
    };
    const Real place = along(rim.x, rim.y);
    const Real step = along(rim.dx, rim.dy);
    const Real start = VectorLane::load(&rim.start[e]);
    const Real end = VectorLane::load(&rim.end[e]);
    const Real a = place + start * step;
    const Real b = place + end * step;
    low = select(start < end, lower(low, lower(a, b)), low);
    high = select(start < end, upper(high, upper(a, b)), high);
  }
  return std::max(0.0, std::experimental::hmax(high) - std::experimental::hmin(low));
}

}  // namespace percolith::mechanics
