// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/contact/pair_states.hpp"

#include <algorithm>

namespace percolith::mechanics {

void PairStates::reserve(std::size_t pairs) {
  nature.reserve(pairs);
  state.reserve(pairs);
  origin.reserve(pairs);
  start.reserve(pairs);
  rest.reserve(pairs);
  force.reserve(pairs);
}

void PairStates::add(const Surface& a, const Surface& b) {
  const double penalty = in_series(a.penalty, b.penalty);
  nature.push_back({b.origin - a.origin,
                    {penalty * a.twice_area, penalty * b.twice_area},
                    in_series(a.tangential_penalty, b.tangential_penalty),
                    std::min(a.friction, b.friction),
                    {a.slot, b.slot}});
  state.emplace_back();
  origin.emplace_back();
  start.push_back(PairStart::fresh);
  rest.push_back(0.0);
  force.push_back(mesh::none);
}

}  // namespace percolith::mechanics
