// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/contact/contact.hpp"
#include "percolith/mechanics/contact/search.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace percolith::mechanics {
namespace {

// Of the mean edge of the candidates: a wider margin means fewer searches, but more pairs.
constexpr double margin_share = 0.2;

double mean_edge(std::span<const PlacedTriangle> placed) {
  double sum = 0.0;
  double count = 0.0;
  for (const PlacedTriangle& t : placed) {
    for (const Point& edge : {t.leg_1, t.leg_2, t.leg_2 - t.leg_1}) {
      const double length = std::sqrt(dot(edge, edge));
      if (std::isfinite(length)) {
        sum += length;
        count += 1.0;
      }
    }
  }
  return count > 0.0 ? sum / count : 0.0;
}

}  // namespace

PlacedTriangle Contact::placed(const mesh::Mesh& mesh, const CornerMotion& motion,
                               Index triangle) const {
  const Index first = mesh::corner_of(triangle, 0);
  const auto shift = [&](Index k) {
    const auto slot = at(first + k * block_width);
    return Point{motion.ux[slot], motion.uy[slot]};
  };
  const auto leg = [&](Index k) {
    const auto slot = at(first + k * block_width);
    return Point{undeformed_.x[slot], undeformed_.y[slot]} + (shift(k) - shift(0));
  };
  return {mesh.place_of(first), shift(0), leg(1), leg(2)};
}

std::vector<PlacedTriangle> Contact::place(const mesh::Mesh& mesh, const CornerMotion& motion,
                                           Execution& execution) const {
  std::vector<PlacedTriangle> all(candidates_.size());
  execution.for_each("contact search", static_cast<Index>(all.size()), [&](ScalarLane lane) {
    const auto i = at(lane.first);
    all[i] = placed(mesh, motion, candidates_[i].triangle);
  });
  return all;
}

void Contact::make_room() {
  const auto blocks = at(padded(states_.size()) / block_width);
  if (blocks > forces_.size()) {
    forces_.resize(blocks + blocks / 8);
  }
}

Surface Contact::surface_of(const mesh::Mesh& mesh, Index triangle) const {
  const auto t = at(triangle);
  return {properties_.penalty[t],
          properties_.tangential_penalty[t],
          properties_.friction[t],
          2.0 * mesh.area(triangle),
          mesh.vertex[at(mesh.triangle_vertex[t][0])],
          mesh::corner_of(triangle, 0)};
}

void Contact::search(const mesh::Mesh& mesh, const CornerMotion& motion, Execution& execution) {
  const std::vector<PlacedTriangle> all = place(mesh, motion, execution);
  margin_ = margin_share * mean_edge(all);
  const PairList list = find_pairs(candidates_, all, margin_, execution);
  const auto start = std::chrono::steady_clock::now();
  PairStates states;
  states.reserve(list.pair.size() + list.pair.size() / 8);
  std::vector<Surface> surface;
  surface.reserve(candidates_.size());
  for (const Candidate& c : candidates_) {
    surface.push_back(surface_of(mesh, c.triangle));
  }
  for (const auto& [a, b] : list.pair) {
    states.add(surface[at(a)], surface[at(b)]);
  }
  PairRows rows(states, mesh.triangles());
  carry_over(states, rows);
  states_ = std::move(states);
  rows_ = std::move(rows);
  make_room();
  clear_forces();
  loosened_.clear();
  travelled_ = 0.0;
  stale_ = false;
  starts_ = true;
  execution.book("contact search", start);
}

void Contact::carry_over(PairStates& states, const PairRows& rows) {
  Index next = 0;
  for (Index old = 0; old < states_.size(); ++old) {
    const PairState<double>& state = states_.state[at(old)];
    const auto key = states_.triangles(old);
    friction_dissipation_ += state.loss;
    // Both lists ascend but for pairs that were added: mostly the next one is that of the same two.
    const bool same = next < states.size() && states.triangles(next) == key;
    const Index p = same ? next : rows.find(states, key[0], key[1]);
    if (p == mesh::none) {
      friction_dissipation_ += state.stored;
      continue;
    }
    next = p + 1;
    states.state[at(p)] = state;
    states.state[at(p)].loss = 0.0;
    states.origin[at(p)] = states_.origin[at(old)];
    states.rest[at(p)] = std::max(0.0, states_.rest[at(old)] - travelled_);
    states.start[at(p)] = PairStart::none;
  }
}

void Contact::add_pairs(const mesh::Mesh& mesh, const CornerMotion& motion, Execution& execution) {
  const auto start = std::chrono::steady_clock::now();
  std::sort(loosened_.begin(), loosened_.end());
  loosened_.erase(std::unique(loosened_.begin(), loosened_.end()), loosened_.end());
  const auto where = [&](Index triangle) { return placed(mesh, motion, triangle); };
  for (const auto& [a, b] : find_pairs_of(loosened_, candidates_, where, margin_)) {
    const Index first = candidates_[at(a)].triangle;
    const Index second = candidates_[at(b)].triangle;
    if (rows_.find(states_, first, second) == mesh::none) {
      states_.add(surface_of(mesh, first), surface_of(mesh, second));
      rows_.insert(states_, states_.size() - 1);
      starts_ = true;
    }
  }
  make_room();
  loosened_.clear();
  execution.book("contact search", start);
}

void Contact::clear_forces() {
  std::vector<std::uint8_t> searched(acts_.size(), 0);
  for (const Index block : blocks_) {
    searched[at(block)] = 1;
  }
  for (std::size_t block = 0; block < acts_.size(); ++block) {
    if (acts_[block] != 0 && searched[block] == 0) {
      const auto slot = static_cast<std::ptrdiff_t>(block) * mesh::corners_per_block;
      std::fill_n(force_x_.begin() + slot, mesh::corners_per_block, 0.0);
      std::fill_n(force_y_.begin() + slot, mesh::corners_per_block, 0.0);
      acts_[block] = 0;
    }
  }
}

}  // namespace percolith::mechanics
