// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/contact/pair_force.hpp"

#include <array>

// Pairs as the lanes of a register: brought together from where their numbers say, and put back.
namespace percolith::mechanics {

/// Pairs of a lane: their numbers, and where their lines and corners start.
template <class Lane>
struct PairLanes {
  using Real = typename Lane::Real;
  using Row = std::array<Index, Lane::width>;
  const PairForces* of;
  const Index* pair;
  Row line;
  std::array<Row, 2> slot;

  PairLanes(const PairForces& forces, const Index* pairs) : of(&forces), pair(pairs) {
    for (std::size_t i = 0; i < Lane::width; ++i) {
      line[i] = pair_stride * pair[i];
      slot[0][i] = of->states->nature[at(pair[i])].slot[0];
      slot[1][i] = of->states->nature[at(pair[i])].slot[1];
    }
  }

  /// A member of the first pair's line stands for that of all.
  [[nodiscard]] Real gather(const double& member) const {
    return Lane::gather(&member, line.data());
  }
  void scatter(double& member, Real value) const { Lane::scatter(&member, line.data(), value); }
  [[nodiscard]] const PairNature& nature() const { return of->states->nature.front(); }

  [[nodiscard]] PairState<Real> load_state() const {
    const PairState<double>& s = of->states->state.front();
    return {gather(s.factor), gather(s.offset), gather(s.tangential),
            gather(s.stored), gather(s.loss),   gather(s.depth)};
  }
  void store_state(const PairState<Real>& state) const {
    PairState<double>& s = of->states->state.front();
    scatter(s.factor, state.factor);
    scatter(s.offset, state.offset);
    scatter(s.tangential, state.tangential);
    scatter(s.stored, state.stored);
    scatter(s.loss, state.loss);
    scatter(s.depth, state.depth);
  }

  /// What the corners of a triangle have of a field that is given per corner slot.
  [[nodiscard]] std::array<Vec2<Real>, 3> corners(std::size_t side, std::span<const double> x,
                                                  std::span<const double> y) const {
    const Index* const own = slot[side].data();
    return {{{Lane::gather(x.data(), own), Lane::gather(y.data(), own)},
             {Lane::gather(x.data() + block_width, own), Lane::gather(y.data() + block_width, own)},
             {Lane::gather(x.data() + 2 * block_width, own),
              Lane::gather(y.data() + 2 * block_width, own)}}};
  }

  /// Where the triangles are, with the operations of `place_pair`.
  [[nodiscard]] PairPlaces<Real> places() const {
    std::array<std::array<Vec2<Real>, 3>, 2> leg;  // corner 0 has the displacement
    for (std::size_t side = 0; side < 2; ++side) {
      const auto u = corners(side, of->motion.ux, of->motion.uy);
      const auto rest = corners(side, of->undeformed->x, of->undeformed->y);
      leg[side] = {u[0], rest[1] + (u[1] - u[0]), rest[2] + (u[2] - u[0])};
    }
    const Vec2<Real> apart{gather(nature().apart.x), gather(nature().apart.y)};
    const Vec2<Real> second = apart + (leg[1][0] - leg[0][0]);
    return {{Vec2<Real>{Real(0.0), Real(0.0)}, leg[0][1], leg[0][2]},
            {second, second + leg[1][1], second + leg[1][2]}};
  }
};

/// N/m, [triangle][corner].
template <class Real>
using PairCornerForces = std::array<std::array<Vec2<Real>, 3>, 2>;

template <class Lane>
void store_forces(double* out, const PairCornerForces<typename Lane::Real>& force) {
  for (const auto& side : force) {
    for (std::size_t k = 0; k < 3; ++k) {
      Lane::store(out + k * block_width, side[k].x);
      Lane::store(out + (3 + k) * block_width, side[k].y);
    }
    out += PairForceBlock::side;
  }
}

}  // namespace percolith::mechanics
