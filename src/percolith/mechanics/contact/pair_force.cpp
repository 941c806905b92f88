// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/contact/pair_force.hpp"

#include "percolith/material/friction.hpp"
#include "percolith/mechanics/contact/pair_lanes.hpp"

#include <algorithm>

namespace percolith::mechanics {
namespace {

// A joint may be so much softer than the overlap; the rest of the difference is an offset, so that
// faces given up under tension still resist what comes later.
constexpr double smallest_factor = 0.1;

// Both triangles of a pair may use up the gap between them; less for round-off.
constexpr double gap_share = 0.499;

void take_over(const PairHandOver& handed, double raw, const Point& along,
               PairState<double>& state) {
  const double joint_force = std::max(0.0, handed.normal_force);
  state.factor =
      raw > 0.0 ? std::clamp(joint_force / raw, smallest_factor, handed.largest_factor) : 1.0;
  state.offset = std::max(0.0, state.factor * raw - joint_force);
  state.tangential = dot(handed.shear, along);
}

/// How pairs take up a force that is there when they are looked at for the first time; `seen`
/// becomes zero for them.
template <class Lane>
void take_up(const PairLanes<Lane>& lanes, typename Lane::Real raw,
             const Vec2<typename Lane::Real>& along, PairState<typename Lane::Real>& state,
             typename Lane::Real& seen) {
  const auto& starts = lanes.of->states->start;
  if (std::all_of(lanes.pair, lanes.pair + Lane::width,
                  [&](Index p) { return starts[at(p)] == PairStart::none; })) {
    return;
  }
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
    const PairStart start = starts[at(lanes.pair[i])];
    known[i] = start == PairStart::none ? 1.0 : 0.0;
    if (start == PairStart::fresh) {
      offset[i] = force[i];
    } else if (start == PairStart::handed) {
      const auto found = std::lower_bound(
          lanes.of->handed.begin(), lanes.of->handed.end(), lanes.pair[i],
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
PairCornerForces<typename Lane::Real> press(const PairLanes<Lane>& lanes,
                                            const OverlapForces<typename Lane::Real>& overlap,
                                            PairState<typename Lane::Real>& state) {
  using Real = typename Lane::Real;
  const Real zero(0.0);
  const PairForces& of = *lanes.of;
  const Real raw = square_root(dot(overlap.total, overlap.total));
  const auto pushes = raw > zero;
  const Real inverse = select(pushes, Real(1.0) / select(pushes, raw, Real(1.0)), zero);
  const Vec2<Real> normal = inverse * overlap.total;
  const Vec2<Real> along{-normal.y, normal.x};
  Real seen(1.0);
  if (of.starts) {
    take_up<Lane>(lanes, raw, along, state, seen);
  }
  // A force that has fallen below the offset takes the offset with it: what is not given back now
  // is given never.
  const Real scaled = state.factor * raw;
  state.offset = smaller(scaled, state.offset);
  const Real force = scaled - state.offset;
  const Real stiffness =
      lanes.gather(lanes.nature().tangential_penalty) * extent_along(overlap, along);
  const auto first = lanes.corners(0, of.motion.vx, of.motion.vy);
  const auto second = lanes.corners(1, of.motion.vx, of.motion.vy);
  const Real speed =
      dot(weighted(first, overlap.centre[0]) - weighted(second, overlap.centre[1]), along);
  rub(stiffness, speed * Real(of.dt), lanes.gather(lanes.nature().friction) * force, seen, state);
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

/// The state of pairs that have parted: nothing is remembered.
template <class Real>
PairState<Real> parted(const PairState<Real>& state) {
  PairState<Real> left;
  left.loss = state.loss + state.stored;
  return left;
}

template <class Mask, class Real>
PairState<Real> choose(const Mask& condition, const PairState<Real>& yes,
                       const PairState<Real>& no) {
  return {select(condition, yes.factor, no.factor),
          select(condition, yes.offset, no.offset),
          select(condition, yes.tangential, no.tangential),
          select(condition, yes.stored, no.stored),
          select(condition, yes.loss, no.loss),
          select(condition, yes.depth, no.depth)};
}

/// Where the triangles of pairs are, and whether they touch.
template <class Lane>
struct Meeting {
  using Real = typename Lane::Real;
  using Mask = decltype(Real() > Real());
  PairPlaces<Real> places;
  std::array<Real, 2> area;  // twice, m2
  PairSides<Real> sides;
  Mask apart, touch;  // neither where a triangle is inverted

  explicit Meeting(const PairLanes<Lane>& lanes)
      : places(lanes.places()), area{twice_area(places.first), twice_area(places.second)},
        sides(pair_sides(places)) {
    const Mask solid = area[0] > Real(0.0) && area[1] > Real(0.0);
    apart = solid && separated(sides);
    touch = solid && !apart;
  }

  /// Way since the search up to which the pairs can rest.
  [[nodiscard]] Real rest(double travelled) const {
    const Real zero(0.0);
    if (!any(apart)) {
      return zero;
    }
    const Real gap = select(apart, gap_between(places, sides), zero);
    return select(gap > zero, Real(travelled) + Real(gap_share) * gap, zero);
  }
};

}  // namespace

template <class Lane>
void PairForces::look(const Index* pair, Index count, PairPick& pressed) const {
  using Real = typename Lane::Real;
  const Meeting<Lane> meeting(PairLanes<Lane>(*this, pair));
  Lane::scatter(states->rest.data(), pair, meeting.rest(travelled));
  if (any(meeting.touch)) {
    std::array<double, Lane::width> touches;
    Lane::store(touches.data(), select(meeting.touch, Real(1.0), Real(0.0)));
    for (Index i = 0; i < count; ++i) {
      pressed.add(pair[at(i)], touches[at(i)] > 0.0);
    }
  }
}

template <class Lane>
void PairForces::advance(const Index* pair, Index count, Index place) const {
  using Real = typename Lane::Real;
  const Real one(1.0);
  const PairLanes<Lane> lanes(*this, pair);
  const Meeting<Lane> meeting(lanes);
  PairState<Real> state = lanes.load_state();
  const PairState<Real> left = parted(state);
  if (any(meeting.touch)) {
    const std::array<Real, 2> area{select(meeting.touch, meeting.area[0], one),
                                   select(meeting.touch, meeting.area[1], one)};
    const auto& stiffness = lanes.nature().stiffness;
    const std::array<Real, 2> penalty{lanes.gather(stiffness[0]) / area[0],
                                      lanes.gather(stiffness[1]) / area[1]};
    const OverlapForces<Real> overlap = overlap_force(meeting.places, meeting.sides, area, penalty);
    store_forces<Lane>(forces->value.data() + force_at(place), press<Lane>(lanes, overlap, state));
  }
  lanes.store_state(choose(meeting.touch, state, left));
  Lane::scatter(states->rest.data(), pair, meeting.rest(travelled));
  note<Lane>(pair, count, place, select(meeting.touch, one, Real(0.0)));
}

/// Notes where the forces are of those pairs whose `touching` is not zero.
template <class Lane>
void PairForces::note(const Index* pair, Index count, Index place,
                      typename Lane::Real touching) const {
  std::array<double, Lane::width> touches;
  Lane::store(touches.data(), touching);
  const Index first = force_at(place);
  for (Index i = 0; i < count; ++i) {
    states->force[at(pair[i])] = touches[at(i)] > 0.0 ? first + i : mesh::none;
    if (starts) {
      states->start[at(pair[i])] = PairStart::none;
    }
  }
}

template void PairForces::look<ScalarLane>(const Index*, Index, PairPick&) const;
template void PairForces::look<VectorLane>(const Index*, Index, PairPick&) const;
template void PairForces::advance<ScalarLane>(const Index*, Index, Index) const;
template void PairForces::advance<VectorLane>(const Index*, Index, Index) const;

}  // namespace percolith::mechanics
