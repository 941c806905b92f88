// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/execution.hpp"
#include "percolith/mechanics/contact/placed_triangle.hpp"
#include "percolith/mesh/mesh.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace percolith::mechanics {

using mesh::Index;

/// How a pair takes up its force when it is looked at for the first time.
enum class PairStart : std::uint8_t {
  none,   ///< it has been looked at
  fresh,  ///< an overlap that is already there gives no force of its own
  handed  ///< it carries on the force of a joint
};

/// What a pair remembers from step to step. The normal force is
/// max(0, factor |f| - offset) along f, the integral (4).
struct PairState {
  double factor = 1.0;
  double offset = 0.0;      ///< N/m
  double tangential = 0.0;  ///< N/m, on the first triangle along t: f turned by +90 degrees
  double stiffness = 0.0;   ///< Pa, of the tangential spring at the last step
  double depth = 0.0;       ///< m, extent of the overlap along f; 0 without overlap
  double loss = 0.0;        ///< J/m, tangential energy lost since the search
};

/// Energy in the tangential spring, J/m.
inline double stored_energy(const PairState& s) {
  return s.stiffness > 0.0 ? 0.5 * s.tangential * s.tangential / s.stiffness : 0.0;
}

/// Force that a joint hands to the contact of its faces, for a pair of the list.
struct PairHandOver {
  Index pair = 0;
  double normal_force = 0.0;  ///< N/m, compression positive
  Point shear;                ///< N/m, on the first triangle
};

/// N/m, [triangle][corner].
using PairForces = std::array<std::array<Point, 3>, 2>;

/// What is kept for each pair of the list.
struct PairStates {
  std::vector<PairState> state;
  std::vector<PairForces> force;       ///< meaningless where the pair does not touch
  std::vector<std::uint8_t> touching;  ///< 1 where the triangles overlap
  std::vector<std::uint8_t> edge;      ///< that separated them last: a hint, no state
  std::vector<PairStart> start;
  void resize(std::size_t pairs);
};

/// What a candidate brings to its pairs.
struct Surface {
  double penalty = 0.0;             ///< p_n of (4), Pa
  double tangential_penalty = 0.0;  ///< p_t of (6), Pa/m
  double friction = 0.0;            ///< tan(phi) of (7)
  double twice_area = 0.0;          ///< m2, undeformed
};

/// Velocities of the corners of a candidate, m/s.
using CornerVelocities = std::array<Point, 3>;

/// The penalty of a pair: both in series, twice as stiff as the softer one at most.
inline double in_series(double a, double b) {
  return a == b ? a : 2.0 * a * b / (a + b);
}

/// The weights of the potentials of a pair, see `overlap_force`.
std::array<double, 2> pair_penalty(const Surface& a, const Surface& b, const PlacedTriangle& now_a,
                                   const PlacedTriangle& now_b);

/// Forces and states of the pairs after a step of length `dt` (s), (4)-(7).
struct PairForceKernel {
  const std::array<Index, 2>* pair;
  const PlacedTriangle* placed;
  const Surface* surface;
  const CornerVelocities* velocity;
  std::span<const PairHandOver> handed;  // ascending pairs
  double dt;
  PairStates* states;

  void operator()(ScalarLane lane) const;
};

}  // namespace percolith::mechanics
