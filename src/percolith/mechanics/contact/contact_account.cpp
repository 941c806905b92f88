// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/contact/contact.hpp"
#include "percolith/mechanics/contact/overlap.hpp"
#include "percolith/mechanics/contact/overlap_force.hpp"
#include "percolith/mechanics/contact/search.hpp"

#include <algorithm>
#include <cmath>

namespace percolith::mechanics {
namespace {

/// The overlap of a pair as the integral (4) sees it: energy, J/m, and force, N/m.
PairOrigin overlap_now(const PlacedPair& pair, const std::array<double, 2>& stiffness) {
  const std::array<double, 2> penalty{stiffness[0] / twice_area(pair.first),
                                      stiffness[1] / twice_area(pair.second)};
  const Polygon overlap = overlap_of(pair.first, pair.second);
  const Point force = overlap_force(pair, penalty).total;
  return {penalty[0] * potential_over(overlap, pair.first) +
              penalty[1] * potential_over(overlap, pair.second),
          std::sqrt(dot(force, force))};
}

/// Energy (J/m) of a pair whose force F is less by `offset` (N/m), int (1 - offset/F) dU from where
/// F was the offset: between the overlap it started from and that of now F is taken as a power of
/// the energy U.
double energy_beyond(const PairOrigin& start, const PairOrigin& now, double offset) {
  if (!(now.force > offset) || !(start.energy > 0.0)) {
    return 0.0;
  }
  const bool grew = now.energy > 1.001 * start.energy && now.force > start.force;
  // Where faces meet the force grows as the root of the energy, where a corner does with 2/3.
  const double power =
      grew ? std::clamp(std::log(now.force / start.force) / std::log(now.energy / start.energy),
                        0.1, 0.95)
           : 0.5;
  const double from = now.energy * std::pow(offset / now.force, 1.0 / power);
  const double rest = 1.0 - power;
  return now.energy - from - from / rest * (std::pow(now.energy / from, rest) - 1.0);
}

}  // namespace

double Contact::friction_dissipation() const {
  CompensatedSum sum = friction_dissipation_;
  for (const auto& state : states_.state) {
    sum += state.loss;
  }
  return sum.total();
}

double Contact::stored_tangential() const {
  CompensatedSum sum;
  for (const auto& state : states_.state) {
    sum += state.stored;
  }
  return sum.total();
}

PairOrigin Contact::overlap_of_pair(const mesh::Mesh& mesh, const CornerMotion& motion,
                                    Index pair) const {
  const auto [a, b] = states_.triangles(pair);
  return overlap_now(place_pair(placed(mesh, motion, a), placed(mesh, motion, b)),
                     states_.nature[at(pair)].stiffness);
}

double Contact::pressed_energy(const mesh::Mesh& mesh, const CornerMotion& motion,
                               Index pair) const {
  const PairOrigin now = overlap_of_pair(mesh, motion, pair);
  const PairState<double>& state = states_.state[at(pair)];
  if (state.offset > 0.0) {
    return state.factor * energy_beyond(states_.origin[at(pair)], now, state.offset / state.factor);
  }
  return state.factor * now.energy;
}

double Contact::potential_energy(const mesh::Mesh& mesh, const CornerMotion& motion) const {
  CompensatedSum sum;
  for (Index p = 0; p < states_.size(); ++p) {
    if (states_.force[at(p)] != mesh::none) {
      sum += pressed_energy(mesh, motion, p);
    }
  }
  return sum.total();
}

ContactRelease Contact::release(const mesh::Mesh& mesh, const CornerMotion& motion,
                                std::span<const std::uint8_t> removed) {
  ContactRelease result;
  CompensatedSum energy;
  for (Index p = 0; p < states_.size(); ++p) {
    const auto triangle = states_.triangles(p);
    const std::array<bool, 2> goes{removed[at(triangle[0])] != 0, removed[at(triangle[1])] != 0};
    Index& place = states_.force[at(p)];
    if (place == mesh::none || (!goes[0] && !goes[1])) {
      continue;
    }
    for (Index side = 0; side < 2; ++side) {
      const double* force = forces_.front().value.data() + place + side * PairForceBlock::side;
      for (Index k = 0; k < 3 && !goes[at(side)]; ++k) {
        result.force.push_back({mesh::corner_of(triangle[at(side)], k),
                                {force[k * block_width], force[(3 + k) * block_width]}});
      }
    }
    PairState<double>& state = states_.state[at(p)];
    energy += pressed_energy(mesh, motion, p) + state.stored;
    state.stored = 0.0;
    place = mesh::none;
  }
  result.energy = energy.total();
  return result;
}

Index Contact::touching_pairs() const {
  return static_cast<Index>(std::count_if(states_.force.begin(), states_.force.end(),
                                          [](Index force) { return force != mesh::none; }));
}

double Contact::deepest() const {
  double deepest = 0.0;
  for (const auto& state : states_.state) {
    deepest = std::max(deepest, state.depth);
  }
  return deepest;
}

void Contact::add_to(StateHash& hash) const {
  hash.add(force_x_);
  hash.add(force_y_);
  hash.add(friction_dissipation());
  hash.add(travelled_);
  for (Index p = 0; p < states_.size(); ++p) {
    for (const Index triangle : states_.triangles(p)) {
      hash.add(triangle);
    }
    const PairState<double>& s = states_.state[at(p)];
    hash.add(std::array<double, 5>{s.factor, s.offset, s.tangential, s.stored, s.depth});
  }
}

std::vector<std::array<Index, 2>>
Contact::overlapping(const mesh::Mesh& mesh, const CornerMotion& motion, double share) const {
  Execution execution(Backend::serial);
  const std::vector<PlacedTriangle> all = place(mesh, motion, execution);
  std::vector<std::array<Index, 2>> found;
  for (const auto& [a, b] : find_pairs(candidates_, all, 0.0, execution).pair) {
    const double smaller = 0.5 * std::min(twice_area(all[at(a)]), twice_area(all[at(b)]));
    const PlacedPair pair = place_pair(all[at(a)], all[at(b)]);
    if (smaller > 0.0 && area_of(overlap_of(pair.first, pair.second)) > share * smaller) {
      found.push_back({candidates_[at(a)].triangle, candidates_[at(b)].triangle});
    }
  }
  return found;
}

}  // namespace percolith::mechanics
