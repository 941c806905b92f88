// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/contact/pair_force.hpp"

#include "percolith/material/friction.hpp"
#include "percolith/mechanics/contact/pair_lanes.hpp"

#include <algorithm>

namespace percolith::mechanics {
namespace {

// A joint may be so much stiffer or softer than the overlap; the rest of the difference is an
// offset, so that faces given up under tension still resist what comes later.
constexpr double largest_factor = 10.0;
constexpr double smallest_factor = 0.1;

// Both triangles of a pair may use up the gap between them; less for round-off.
constexpr double gap_share = 0.499;

void take_over(const PairHandOver& handed, double raw, const Point& along,
               PairState<double>& state) {
  const double joint_force = std::max(0.0, handed.normal_force);
  state.factor = raw > 0.0 ? std::clamp(joint_force / raw, smallest_factor, largest_factor) : 1.0;
  state.offset = std::max(0.0, state.factor * raw - joint_force);
  state.tangential = dot(handed.shear, along);
}

/// How pairs take up a force that is there when they are looked at for the first time; `seen`
/// becomes zero for them.
template <class Lane>
void take_up(const PairForces& of, const Index* pair, typename Lane::Real raw,
             const Vec2<typename Lane::Real>& along, PairState<typename Lane::Real>& state,
             typename Lane::Real& seen) {
  using Row = std::array<double, Lane::width>;
  Row force, x, y, factor, offset, tangential, known;
  const auto exchange = [&](const auto& move) {
    move(factor, state.factor);
    move(offset, state.offset);
    move(tangential, state.tangential);
    move(known, seen);
  };
  exchange([](Row& row, typename Lane::Real& value) { Lane::store(row.data(), value); });
  Lane::store(force.data(), raw);
  Lane::store(x.data(), along.x);
  Lane::store(y.data(), along.y);
  for (std::size_t i = 0; i < Lane::width; ++i) {
    const PairStart start = of.states->start[at(pair[i])];
    known[i] = start == PairStart::none ? 1.0 : 0.0;
    if (start == PairStart::fresh) {
      offset[i] = force[i];
    } else if (start == PairStart::handed) {
      const auto found = std::lower_bound(
          of.handed.begin(), of.handed.end(), pair[i],
          [](const PairHandOver& entry, Index wanted) { return entry.pair < wanted; });
      PairState<double> one{};
      take_over(*found, force[i], {x[i], y[i]}, one);
      factor[i] = one.factor;
      offset[i] = one.offset;
      tangential[i] = one.tangential;
    }
  }
  exchange([](Row& row, typename Lane::Real& value) { value = Lane::load(row.data()); });
}

/// Advances the tangential force and books what it lost; a spring that became stiffer or softer at
/// the same force counts too, so that work, storage and loss add up.
template <class Real>
void rub(Real stiffness, Real displacement, Real limit, Real seen, PairState<Real>& state) {
  const Real zero(0.0);
  const auto holds = stiffness > zero;
  const Real k = select(holds, stiffness, Real(1.0));
  const Real half_softness = Real(0.5) / k;
  const Real before = state.stored;
  const Real changed =
      select(seen > zero, before - half_softness * (state.tangential * state.tangential), zero);
  const auto step =
      material::friction_step(state.tangential, k, select(seen > zero, displacement, zero), limit);
  state.tangential = select(holds, step.force, zero);
  state.stored = half_softness * (state.tangential * state.tangential);
  state.loss = state.loss + select(holds, changed + step.loss, before);
}

template <class Real>
Vec2<Real> weighted(const std::array<Vec2<Real>, 3>& value, const std::array<Real, 3>& weight) {
  return weight[0] * value[0] + weight[1] * value[1] + weight[2] * value[2];
}

/// Normal and tangential forces of pairs that touch; the state is advanced.
template <class Lane>
PairCornerForces<typename Lane::Real>
press(const PairForces& of, const Index* pair, const PairSlots<Lane>& slots,
      const OverlapForces<typename Lane::Real>& overlap, PairState<typename Lane::Real>& state) {
  using Real = typename Lane::Real;
  const Real zero(0.0);
  const Real raw = square_root(dot(overlap.total, overlap.total));
  const auto pushes = raw > zero;
  const Real inverse = select(pushes, Real(1.0) / select(pushes, raw, Real(1.0)), zero);
  const Vec2<Real> normal = inverse * overlap.total;
  const Vec2<Real> along{-normal.y, normal.x};
  Real seen(1.0);
  if (of.starts) {
    take_up<Lane>(of, pair, raw, along, state, seen);
  }
  // A force that has fallen below the offset takes the offset with it: what is not given back now
  // is given never.
  const Real scaled = state.factor * raw;
  state.offset = smaller(scaled, state.offset);
  const Real force = scaled - state.offset;
  const Real stiffness =
      Lane::gather(of.states->tangential_penalty.data(), pair) * extent_along(overlap, along);
  const auto first = slots.corners(0, of.motion.vx, of.motion.vy);
  const auto second = slots.corners(1, of.motion.vx, of.motion.vy);
  const Real speed =
      dot(weighted(first, overlap.centre[0]) - weighted(second, overlap.centre[1]), along);
  rub(stiffness, speed * Real(of.dt), Lane::gather(of.states->friction.data(), pair) * force, seen,
      state);
  state.depth = extent_along(overlap, normal);
  const Real scale = inverse * force;
  const Vec2<Real> shear = state.tangential * along;
  PairCornerForces<Real> result;
  for (std::size_t k = 0; k < 3; ++k) {
    result[0][k] = scale * overlap.on[0][k] + overlap.centre[0][k] * shear;
    result[1][k] = scale * overlap.on[1][k] - overlap.centre[1][k] * shear;
  }
  return result;
}

}  // namespace

template <class Lane>
void PairForces::advance(const Index* pair, Index count, Index place) const {
  using Real = typename Lane::Real;
  const Real zero(0.0);
  const Real one(1.0);
  const PairSlots<Lane> slots(*states, pair);
  const PairPlaces<Real> now = places_of<Lane>(*this, pair, slots);
  const std::array<Real, 2> area{twice_area(now.first), twice_area(now.second)};
  const auto solid = area[0] > zero && area[1] > zero;
  const PairSides<Real> sides = pair_sides(now);
  const auto apart = solid && separated(sides);
  const auto touch = solid && !apart;
  PairState<Real> state = load_state<Lane>(*states, pair);
  // What has parted remembers nothing.
  PairState<Real> parted{one, zero, zero, zero, state.loss + state.stored, zero, zero};
  if (any(apart)) {
    const Real gap = select(apart, gap_between(now, sides), zero);
    parted.rest = select(gap > zero, Real(travelled) + Real(gap_share) * gap, zero);
  }
  if (any(touch)) {
    const std::array<Real, 2> safe{select(touch, area[0], one), select(touch, area[1], one)};
    const std::array<Real, 2> penalty{Lane::gather(states->stiffness_first.data(), pair) / safe[0],
                                      Lane::gather(states->stiffness_second.data(), pair) /
                                          safe[1]};
    state.rest = zero;
    const auto forces =
        press<Lane>(*this, pair, slots, overlap_force(now, sides, safe, penalty), state);
    store_forces<Lane>(*records, place, forces);
    store_places<Lane>(*records, place, now);
  }
  store_state<Lane>(*states, pair, choose(touch, state, parted));
  std::array<double, Lane::width> touching;
  Lane::store(touching.data(), select(touch, one, zero));
  for (Index i = 0; i < count; ++i) {
    states->place[at(pair[i])] = touching[at(i)] > 0.0 ? place + i : mesh::none;
  }
  if (starts) {
    for (Index i = 0; i < count; ++i) {
      states->start[at(pair[i])] = PairStart::none;
    }
  }
}

template void PairForces::advance<ScalarLane>(const Index*, Index, Index) const;
template void PairForces::advance<VectorLane>(const Index*, Index, Index) const;

}  // namespace percolith::mechanics
