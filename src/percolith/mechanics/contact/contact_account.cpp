// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/contact/contact.hpp"
#include "percolith/mechanics/contact/overlap.hpp"
#include "percolith/mechanics/contact/overlap_force.hpp"
#include "percolith/mechanics/contact/search.hpp"

#include <algorithm>
#include <cmath>

namespace percolith::mechanics {

namespace {

PlacedPair position_of(const PairRecords& records, Index place) {
  const double* from = records.position.data() + position_at(place);
  std::array<Point, 5> corner;
  for (Point& p : corner) {
    p = {from[0], from[block_width]};
    from += 2 * block_width;
  }
  return {{Point{}, corner[0], corner[1]}, {corner[2], corner[3], corner[4]}};
}

}  // namespace

double Contact::friction_dissipation() const {
  CompensatedSum sum = friction_dissipation_;
  for (const double loss : states_.loss) {
    sum += loss;
  }
  return sum.total();
}

double Contact::stored_tangential() const {
  CompensatedSum sum;
  for (const double stored : states_.stored) {
    sum += stored;
  }
  return sum.total();
}

double Contact::potential_energy() const {
  CompensatedSum sum;
  for (std::size_t p = 0; p < states_.place.size(); ++p) {
    if (states_.place[p] == mesh::none) {
      continue;
    }
    const PlacedPair now = position_of(records_, states_.place[p]);
    const std::array<double, 2> penalty{states_.stiffness_first[p] / twice_area(now.first),
                                        states_.stiffness_second[p] / twice_area(now.second)};
    const Polygon overlap = overlap_of(now.first, now.second);
    double share = states_.factor[p];
    if (states_.offset[p] > 0.0) {
      const Point total = overlap_force(now, penalty).total;
      const double force = states_.factor[p] * std::sqrt(dot(total, total));
      const double left = force > 0.0 ? std::max(0.0, 1.0 - states_.offset[p] / force) : 0.0;
      share *= left * left;
    }
    sum += share * (penalty[0] * potential_over(overlap, now.first) +
                    penalty[1] * potential_over(overlap, now.second));
  }
  return sum.total();
}

Index Contact::touching_pairs() const {
  return static_cast<Index>(std::count_if(states_.place.begin(), states_.place.end(),
                                          [](Index place) { return place != mesh::none; }));
}

double Contact::deepest() const {
  double deepest = 0.0;
  for (const double depth : states_.depth) {
    deepest = std::max(deepest, depth);
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
    hash.add(std::array<double, 5>{states_.factor[at(p)], states_.offset[at(p)],
                                   states_.tangential[at(p)], states_.stored[at(p)],
                                   states_.depth[at(p)]});
  }
}

std::vector<std::array<Index, 2>>
Contact::overlapping(const mesh::Mesh& mesh, const CornerMotion& motion, double share) const {
  Execution execution(Backend::serial);
  const std::vector<PlacedTriangle> placed = place(mesh, motion, execution);
  std::vector<std::array<Index, 2>> found;
  for (const auto& [a, b] : find_pairs(candidates_, placed, 0.0, execution).pair) {
    const double smaller = 0.5 * std::min(twice_area(placed[at(a)]), twice_area(placed[at(b)]));
    const PlacedPair pair = place_pair(placed[at(a)], placed[at(b)]);
    if (smaller > 0.0 && area_of(overlap_of(pair.first, pair.second)) > share * smaller) {
      found.push_back({candidates_[at(a)].triangle, candidates_[at(b)].triangle});
    }
  }
  return found;
}

}  // namespace percolith::mechanics
