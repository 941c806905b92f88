// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/contact/pair_force.hpp"

#include "percolith/material/friction.hpp"
#include "percolith/mechanics/contact/overlap_force.hpp"

#include <algorithm>
#include <cmath>

namespace percolith::mechanics {
namespace {

// A joint may be so much stiffer or softer than the overlap; the rest of the difference is an
// offset, so that faces given up under tension still resist what comes later.
constexpr double largest_factor = 10.0;
constexpr double smallest_factor = 0.1;

/// The overlap is gone: nothing is remembered.
void part(PairState& state) {
  const double loss = state.loss + stored_energy(state);
  state = PairState{};
  state.loss = loss;
}

void take_over(const PairHandOver& handed, double raw, const Point& along, PairState& state) {
  const double joint_force = std::max(0.0, handed.normal_force);
  state.factor = raw > 0.0 ? std::clamp(joint_force / raw, smallest_factor, largest_factor) : 1.0;
  state.offset = std::max(0.0, state.factor * raw - joint_force);
  state.tangential = dot(handed.shear, along);
}

/// The normal force that is left of the integral `raw`. A force that has fallen below the offset
/// takes the offset with it: what is not given back now is given never.
double effective_force(double raw, PairState& state) {
  const double scaled = state.factor * raw;
  state.offset = std::min(state.offset, scaled);
  return scaled - state.offset;
}

Point weighted(const std::array<Point, 3>& value, const std::array<double, 3>& weight) {
  return weight[0] * value[0] + weight[1] * value[1] + weight[2] * value[2];
}

/// Advances the tangential force and books what it lost; a spring that became stiffer or softer at
/// the same force counts too, so that work, storage and loss add up.
void rub(double stiffness, double displacement, double limit, bool first, PairState& state) {
  const double before = stored_energy(state);
  state.stiffness = stiffness;
  if (!(stiffness > 0.0)) {
    state.tangential = 0.0;
    state.loss += before;
    return;
  }
  const double changed = first ? 0.0 : before - stored_energy(state);
  const auto step = material::friction_step(state.tangential, stiffness, displacement, limit);
  state.tangential = step.force;
  state.loss += changed + step.loss;
}

void add_tangential(const OverlapForce& overlap, const Point& force, PairForces& forces) {
  for (std::size_t k = 0; k < 3; ++k) {
    forces[0][k] = forces[0][k] + overlap.centre[0][k] * force;
    forces[1][k] = forces[1][k] - overlap.centre[1][k] * force;
  }
}

}  // namespace

void PairStates::resize(std::size_t pairs) {
  state.assign(pairs, PairState{});
  force.resize(pairs);
  touching.assign(pairs, 0);
  edge.assign(pairs, 0);
  start.assign(pairs, PairStart::fresh);
}

std::array<double, 2> pair_penalty(const Surface& a, const Surface& b, const PlacedTriangle& now_a,
                                   const PlacedTriangle& now_b) {
  const double penalty = in_series(a.penalty, b.penalty);
  return {penalty * a.twice_area / twice_area(now_a), penalty * b.twice_area / twice_area(now_b)};
}

void PairForceKernel::operator()(ScalarLane lane) const {
  const auto p = at(lane.first);
  const auto a = at(pair[p][0]);
  const auto b = at(pair[p][1]);
  const PairStart start = states->start[p];
  if (start != PairStart::none) {
    states->start[p] = PairStart::none;
  }
  const bool solid = twice_area(placed[a]) > 0.0 && twice_area(placed[b]) > 0.0;
  const PlacedPair now = place_pair(placed[a], placed[b]);
  if (!solid || separated(now, states->edge[p])) {
    if (states->touching[p] != 0) {
      states->touching[p] = 0;
      part(states->state[p]);
    }
    return;
  }
  PairState& state = states->state[p];
  const OverlapForce overlap =
      overlap_force(now, pair_penalty(surface[a], surface[b], placed[a], placed[b]));
  const double raw = std::sqrt(dot(overlap.total, overlap.total));
  const Point normal = raw > 0.0 ? (1.0 / raw) * overlap.total : Point{};
  const Point along{-normal.y, normal.x};
  if (start == PairStart::fresh) {
    state.offset = raw;
  } else if (start == PairStart::handed) {
    const auto found = std::lower_bound(
        handed.begin(), handed.end(), lane.first,
        [](const PairHandOver& entry, Index wanted) { return entry.pair < wanted; });
    take_over(*found, raw, along, state);
  }
  const double force = effective_force(raw, state);
  const double scale = raw > 0.0 ? force / raw : 0.0;
  PairForces& forces = states->force[p];
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t k = 0; k < 3; ++k) {
      forces[side][k] = scale * overlap.on[side][k];
    }
  }
  const double length = extent_along(overlap, along);
  const double stiffness =
      in_series(surface[a].tangential_penalty, surface[b].tangential_penalty) * length;
  const double speed = dot(
      weighted(velocity[a], overlap.centre[0]) - weighted(velocity[b], overlap.centre[1]), along);
  const double limit = std::min(surface[a].friction, surface[b].friction) * force;
  const bool first = start != PairStart::none;
  rub(stiffness, first ? 0.0 : speed * dt, limit, first, state);
  add_tangential(overlap, state.tangential * along, forces);
  state.depth = extent_along(overlap, normal);
  states->touching[p] = 1;
}

}  // namespace percolith::mechanics
