// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/contact/pair_states.hpp"

#include <algorithm>

namespace percolith::mechanics {

void PairStates::reserve(std::size_t pairs) {
  for (auto* values : {&first, &second, &place}) {
    values->reserve(pairs);
  }
  for (auto* values : {&apart_x, &apart_y, &stiffness_first, &stiffness_second, &tangential_penalty,
                       &friction, &factor, &offset, &tangential, &stored, &loss, &depth, &rest}) {
    values->reserve(pairs);
  }
  start.reserve(pairs);
}

void PairStates::add(Index first_slot, Index second_slot, const Surface& a, const Surface& b) {
  const double penalty = in_series(a.penalty, b.penalty);
  const Point apart = b.origin - a.origin;
  first.push_back(first_slot);
  second.push_back(second_slot);
  apart_x.push_back(apart.x);
  apart_y.push_back(apart.y);
  stiffness_first.push_back(penalty * a.twice_area);
  stiffness_second.push_back(penalty * b.twice_area);
  tangential_penalty.push_back(in_series(a.tangential_penalty, b.tangential_penalty));
  friction.push_back(std::min(a.friction, b.friction));
  factor.push_back(1.0);
  for (auto* values : {&offset, &tangential, &stored, &loss, &depth, &rest}) {
    values->push_back(0.0);
  }
  start.push_back(PairStart::fresh);
  place.push_back(mesh::none);
}

void PairRecords::make_room(Index pairs) {
  const auto blocks = at(padded(pairs) / block_width);
  if (blocks * at(forces_of_block) > force.size()) {
    const std::size_t more = blocks + blocks / 8;
    force.resize(more * at(forces_of_block));
    position.resize(more * at(positions_of_block));
  }
}

}  // namespace percolith::mechanics
