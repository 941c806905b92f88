// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/contact/pair_force.hpp"

#include <array>

// Pairs as the lanes of a register: brought together from where their numbers say, and put back.
namespace percolith::mechanics {

/// What a pair remembers, see `PairStates`.
template <class Real>
struct PairState {
  Real factor, offset, tangential, stored, loss, depth, rest;
};

template <class Lane>
PairState<typename Lane::Real> load_state(const PairStates& states, const Index* pair) {
  const auto load = [&](const std::vector<double>& from) {
    return Lane::gather(from.data(), pair);
  };
  return {load(states.factor), load(states.offset), load(states.tangential), load(states.stored),
          load(states.loss),   load(states.depth),  load(states.rest)};
}

template <class Lane>
void store_state(PairStates& states, const Index* pair,
                 const PairState<typename Lane::Real>& state) {
  Lane::scatter(states.factor.data(), pair, state.factor);
  Lane::scatter(states.offset.data(), pair, state.offset);
  Lane::scatter(states.tangential.data(), pair, state.tangential);
  Lane::scatter(states.stored.data(), pair, state.stored);
  Lane::scatter(states.loss.data(), pair, state.loss);
  Lane::scatter(states.depth.data(), pair, state.depth);
  Lane::scatter(states.rest.data(), pair, state.rest);
}

template <class Mask, class Real>
PairState<Real> choose(const Mask& condition, const PairState<Real>& yes,
                       const PairState<Real>& no) {
  return {select(condition, yes.factor, no.factor),
          select(condition, yes.offset, no.offset),
          select(condition, yes.tangential, no.tangential),
          select(condition, yes.stored, no.stored),
          select(condition, yes.loss, no.loss),
          select(condition, yes.depth, no.depth),
          select(condition, yes.rest, no.rest)};
}

/// Slots of corner 0 of both triangles of each pair.
template <class Lane>
struct PairSlots {
  std::array<std::array<Index, Lane::width>, 2> slot;

  PairSlots(const PairStates& states, const Index* pair) {
    for (std::size_t i = 0; i < Lane::width; ++i) {
      slot[0][i] = states.first[at(pair[i])];
      slot[1][i] = states.second[at(pair[i])];
    }
  }

  /// What the corners of a triangle have of a field that is given per corner slot.
  [[nodiscard]] std::array<Vec2<typename Lane::Real>, 3>
  corners(std::size_t side, std::span<const double> x, std::span<const double> y) const {
    const Index* const own = slot[side].data();
    return {{{Lane::gather(x.data(), own), Lane::gather(y.data(), own)},
             {Lane::gather(x.data() + block_width, own), Lane::gather(y.data() + block_width, own)},
             {Lane::gather(x.data() + 2 * block_width, own),
              Lane::gather(y.data() + 2 * block_width, own)}}};
  }
};

/// Where the triangles are, with the operations of `place_pair`.
template <class Lane>
PairPlaces<typename Lane::Real> places_of(const PairForces& of, const Index* pair,
                                          const PairSlots<Lane>& slots) {
  using Real = typename Lane::Real;
  std::array<std::array<Vec2<Real>, 3>, 2> leg;  // corner 0 has the displacement
  for (std::size_t side = 0; side < 2; ++side) {
    const auto u = slots.corners(side, of.motion.ux, of.motion.uy);
    const auto rest = slots.corners(side, of.undeformed->x, of.undeformed->y);
    leg[side] = {u[0], rest[1] + (u[1] - u[0]), rest[2] + (u[2] - u[0])};
  }
  const Vec2<Real> apart{Lane::gather(of.states->apart_x.data(), pair),
                         Lane::gather(of.states->apart_y.data(), pair)};
  const Vec2<Real> second = apart + (leg[1][0] - leg[0][0]);
  return {{Vec2<Real>{Real(0.0), Real(0.0)}, leg[0][1], leg[0][2]},
          {second, second + leg[1][1], second + leg[1][2]}};
}

template <class Lane>
void store_places(PairRecords& records, Index place,
                  const PairPlaces<typename Lane::Real>& places) {
  double* out = records.position.data() + position_at(place);
  const auto store = [&](const Vec2<typename Lane::Real>& p) {
    Lane::store(out, p.x);
    Lane::store(out + block_width, p.y);
    out += 2 * block_width;
  };
  store(places.first[1]);
  store(places.first[2]);
  for (const auto& corner : places.second) {
    store(corner);
  }
}

/// N/m, [triangle][corner].
template <class Real>
using PairCornerForces = std::array<std::array<Vec2<Real>, 3>, 2>;

template <class Lane>
void store_forces(PairRecords& records, Index place,
                  const PairCornerForces<typename Lane::Real>& force) {
  double* out = records.force.data() + force_at(place);
  for (const auto& side : force) {
    for (std::size_t k = 0; k < 3; ++k) {
      Lane::store(out + k * block_width, side[k].x);
      Lane::store(out + (3 + k) * block_width, side[k].y);
    }
    out += forces_of_side;
  }
}

}  // namespace percolith::mechanics
