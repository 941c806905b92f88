// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/contact/contact.hpp"
#include "percolith/mechanics/contact/overlap.hpp"
#include "percolith/mechanics/contact/overlap_force.hpp"
#include "percolith/mechanics/contact/search.hpp"

#include <algorithm>
#include <cmath>

namespace percolith::mechanics {

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

double Contact::potential_energy(const mesh::Mesh& mesh, const CornerMotion& motion) const {
  CompensatedSum sum;
  for (Index p = 0; p < states_.size(); ++p) {
    if (states_.force[at(p)] == mesh::none) {
      continue;
    }
    const auto [a, b] = states_.triangles(p);
    const PlacedPair now = place_pair(placed(mesh, motion, a), placed(mesh, motion, b));
    const auto& stiffness = states_.nature[at(p)].stiffness;
    const std::array<double, 2> penalty{stiffness[0] / twice_area(now.first),
                                        stiffness[1] / twice_area(now.second)};
    const Polygon overlap = overlap_of(now.first, now.second);
    const PairState<double>& state = states_.state[at(p)];
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
