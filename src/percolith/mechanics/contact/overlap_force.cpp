// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/contact/overlap_force.hpp"

#include <algorithm>
#include <cmath>

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

/// Area coordinates of the other triangle along an edge: lambda_i = start_i + slope_i t, 0 <= t
/// <= 1.
struct Coordinates {
  std::array<double, 3> start, slope;
  [[nodiscard]] double operator()(std::size_t i, double t) const { return start[i] + slope[i] * t; }
  /// The potential phi; never negative, even where rounding left the triangle.
  [[nodiscard]] double potential(double t) const {
    return 3.0 * std::max(0.0, std::min({(*this)(0, t), (*this)(1, t), (*this)(2, t)}));
  }
  /// Which coordinate is the smallest.
  [[nodiscard]] std::size_t smallest(double t) const {
    const double a = (*this)(0, t);
    const double b = (*this)(1, t);
    return (*this)(2, t) < std::min(a, b) ? 2 : (b < a ? 1 : 0);
  }
};

/// The part of an edge within the other triangle.
struct Part {
  double start = 0.0, end = 1.0;
};

/// False where the edge does not enter the other triangle.
bool clip(const Coordinates& lambda, const std::array<double, 3>& last, Part& part) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double a = lambda.start[i];
    const double b = last[i];
    if (a <= 0.0 && b <= 0.0) {
      return false;
    }
    if (a < 0.0) {
      part.start = std::max(part.start, a / (a - b));
    } else if (b < 0.0) {
      part.end = std::min(part.end, a / (a - b));
    }
  }
  return part.start < part.end;
}

/// Integrals over t of the potential, and of the potential times t.
struct Load {
  double sum = 0.0, moment = 0.0;
  /// Adds a piece on which the potential is linear.
  void add(double t0, double phi0, double t1, double phi1) {
    const double half = 0.5 * (t1 - t0);
    sum += half * (phi0 + phi1);
    moment += half * (1.0 / 3.0) * (t0 * (2.0 * phi0 + phi1) + t1 * (phi0 + 2.0 * phi1));
  }
};

/// Where two coordinates are equal, kept within the part.
double crossing(const Coordinates& lambda, std::size_t i, std::size_t j, const Part& part) {
  const double slope = lambda.slope[i] - lambda.slope[j];
  if (slope == 0.0) {
    return part.end;
  }
  return std::clamp((lambda.start[j] - lambda.start[i]) / slope, part.start, part.end);
}

Load integrate(const Coordinates& lambda, const Part& part) {
  Load load;
  const double phi_start = lambda.potential(part.start);
  const double phi_end = lambda.potential(part.end);
  // What is smallest at both ends is smallest all the way.
  if (lambda.smallest(part.start) == lambda.smallest(part.end)) {
    load.add(part.start, phi_start, part.end, phi_end);
    return load;
  }
  std::array<double, 3> t{crossing(lambda, 0, 1, part), crossing(lambda, 0, 2, part),
                          crossing(lambda, 1, 2, part)};
  std::sort(t.begin(), t.end());
  double before = part.start;
  double phi_before = phi_start;
  for (const double now : t) {
    const double phi = lambda.potential(now);
    load.add(before, phi_before, now, phi);
    before = now;
    phi_before = phi;
  }
  load.add(before, phi_before, part.end, phi_end);
  return load;
}

/// Area coordinates of the corners of `own` in `other`: [corner][coordinate].
std::array<std::array<double, 3>, 3> coordinates_in(const Corners& other, const Corners& own) {
  const double inverse = 1.0 / cross(other[1] - other[0], other[2] - other[0]);
  std::array<std::array<double, 3>, 3> lambda;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      lambda[k][i] = inverse * beside_edge(other, next(i), own[k]);
    }
  }
  return lambda;
}

/// Adds the edges of triangle `side` within the other one; `penalty` is that of the other.
void add_edges(const Corners& own, const Corners& other, double penalty, std::size_t side,
               OverlapForce& result) {
  const auto lambda = coordinates_in(other, own);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t last = next(k);
    const Coordinates along{lambda[k],
                            {lambda[last][0] - lambda[k][0], lambda[last][1] - lambda[k][1],
                             lambda[last][2] - lambda[k][2]}};
    Part part;
    if (!clip(along, lambda[last], part)) {
      continue;
    }
    const Point edge = own[last] - own[k];
    result.rim[result.rim_points++] = own[k] + part.start * edge;
    result.rim[result.rim_points++] = own[k] + part.end * edge;
    const Load load = integrate(along, part);
    const Point push = -penalty * clockwise(edge);
    const double weight = penalty * std::sqrt(dot(edge, edge));
    const auto add = [&](std::size_t triangle, std::size_t corner, double share, double sign) {
      result.on[triangle][corner] = result.on[triangle][corner] + (sign * share) * push;
      result.centre[triangle][corner] += share * weight;
    };
    add(side, k, load.sum - load.moment, 1.0);
    add(side, last, load.moment, 1.0);
    for (std::size_t i = 0; i < 3; ++i) {
      add(1 - side, i, along.start[i] * load.sum + along.slope[i] * load.moment, -1.0);
    }
  }
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
  add_edges(pair.first, pair.second, penalty[1], 0, result);
  add_edges(pair.second, pair.first, penalty[0], 1, result);
  result.total = result.on[0][0] + result.on[0][1] + result.on[0][2];
  for (auto& weights : result.centre) {
    const double sum = weights[0] + weights[1] + weights[2];
    for (double& w : weights) {
      w = sum > 0.0 ? w / sum : 0.0;
    }
  }
  return result;
}

double extent_along(const OverlapForce& overlap, const Point& direction) {
  if (overlap.rim_points == 0) {
    return 0.0;
  }
  double low = dot(overlap.rim[0], direction);
  double high = low;
  for (std::size_t i = 1; i < overlap.rim_points; ++i) {
    const double place = dot(overlap.rim[i], direction);
    low = std::min(low, place);
    high = std::max(high, place);
  }
  return high - low;
}

}  // namespace percolith::mechanics
