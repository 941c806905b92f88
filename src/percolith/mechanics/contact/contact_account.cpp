// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/contact/contact.hpp"
#include "percolith/mechanics/contact/overlap.hpp"
#include "percolith/mechanics/contact/overlap_force.hpp"

#include <algorithm>
#include <cmath>

namespace percolith::mechanics {

double Contact::friction_dissipation() const {
  CompensatedSum sum = friction_dissipation_;
  for (const PairState& state : pairs_.state) {
    sum += state.loss;
  }
  return sum.total();
}

double Contact::stored_tangential() const {
  CompensatedSum sum;
  for (const PairState& state : pairs_.state) {
    sum += stored_energy(state);
  }
  return sum.total();
}

double Contact::potential_energy() const {
  CompensatedSum sum;
  for (std::size_t p = 0; p < list_.pair.size(); ++p) {
    if (pairs_.touching[p] == 0) {
      continue;
    }
    const auto a = at(list_.pair[p][0]);
    const auto b = at(list_.pair[p][1]);
    const PlacedPair now = place_pair(placed_[a], placed_[b]);
    const auto penalty = pair_penalty(surface_[a], surface_[b], placed_[a], placed_[b]);
    const Polygon overlap = overlap_of(now.first, now.second);
    const PairState& state = pairs_.state[p];
    double share = state.factor;
    if (state.offset > 0.0) {
      const Point total = overlap_force(now, penalty).total;
      const double force = state.factor * std::sqrt(dot(total, total));
      const double left = force > 0.0 ? std::max(0.0, 1.0 - state.offset / force) : 0.0;
      share *= left * left;
    }
    sum += share * (penalty[0] * potential_over(overlap, now.first) +
                    penalty[1] * potential_over(overlap, now.second));
  }
  return sum.total();
}

Index Contact::touching_pairs() const {
  return static_cast<Index>(std::count(pairs_.touching.begin(), pairs_.touching.end(), 1));
}

double Contact::deepest() const {
  double deepest = 0.0;
  for (const PairState& state : pairs_.state) {
    deepest = std::max(deepest, state.depth);
  }
  return deepest;
}

void Contact::add_to(StateHash& hash) const {
  hash.add(force_x_);
  hash.add(force_y_);
  hash.add(friction_dissipation());
  hash.add(travelled_);
  for (std::size_t p = 0; p < list_.pair.size(); ++p) {
    hash.add(searched_[at(list_.pair[p][0])]);
    hash.add(searched_[at(list_.pair[p][1])]);
    const PairState& s = pairs_.state[p];
    hash.add(std::array<double, 5>{s.factor, s.offset, s.tangential, s.stiffness, s.depth});
  }
}

std::vector<std::array<Index, 2>>
Contact::overlapping(const mesh::Mesh& mesh, const CornerMotion& motion, double share) const {
  Contact now = *this;
  Execution execution(Backend::serial);
  now.place(mesh, motion, execution);
  std::vector<std::array<Index, 2>> found;
  for (const auto& [a, b] : find_pairs(now.candidates_, now.placed_, 0.0, execution).pair) {
    const double smaller =
        0.5 * std::min(twice_area(now.placed_[at(a)]), twice_area(now.placed_[at(b)]));
    const PlacedPair pair = place_pair(now.placed_[at(a)], now.placed_[at(b)]);
    if (smaller > 0.0 && area_of(overlap_of(pair.first, pair.second)) > share * smaller) {
      found.push_back({candidates_[at(a)].triangle, candidates_[at(b)].triangle});
    }
  }
  return found;
}

}  // namespace percolith::mechanics
