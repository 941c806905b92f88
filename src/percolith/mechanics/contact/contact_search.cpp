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

/// Brings what the corner slots hold into one place for each candidate.
struct Place {
  const mesh::Mesh* mesh;
  CornerMotion motion;
  const CornerPlaces* undeformed;
  const Candidate* candidate;
  PlacedTriangle* placed;

  void operator()(ScalarLane lane) const {
    const Index first = mesh::corner_of(candidate[lane.first].triangle, 0);
    const auto shift = [&](Index k) {
      const auto slot = at(first + k * block_width);
      return Point{motion.ux[slot], motion.uy[slot]};
    };
    const auto leg = [&](Index k) {
      const auto slot = at(first + k * block_width);
      return Point{undeformed->x[slot], undeformed->y[slot]} + (shift(k) - shift(0));
    };
    placed[lane.first] = {mesh->place_of(first), shift(0), leg(1), leg(2)};
  }
};

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

std::vector<PlacedTriangle> Contact::place(const mesh::Mesh& mesh, const CornerMotion& motion,
                                           Execution& execution) const {
  std::vector<PlacedTriangle> placed(candidates_.size());
  execution.for_each("contact search", static_cast<Index>(candidates_.size()),
                     Place{&mesh, motion, &undeformed_, candidates_.data(), placed.data()});
  return placed;
}

Surface Contact::surface_of(const mesh::Mesh& mesh, Index triangle) const {
  const auto t = at(triangle);
  return {properties_.penalty[t], properties_.tangential_penalty[t], properties_.friction[t],
          2.0 * mesh.area(triangle), mesh.vertex[at(mesh.triangle_vertex[t][0])]};
}

void Contact::add_pair(const mesh::Mesh& mesh, Index a, Index b, PairStates& states) const {
  states.add(mesh::corner_of(a, 0), mesh::corner_of(b, 0), surface_of(mesh, a),
             surface_of(mesh, b));
}

void Contact::search(const mesh::Mesh& mesh, const CornerMotion& motion, Execution& execution) {
  const std::vector<PlacedTriangle> placed = place(mesh, motion, execution);
  margin_ = margin_share * mean_edge(placed);
  const PairList list = find_pairs(candidates_, placed, margin_, execution);
  const auto start = std::chrono::steady_clock::now();
  PairStates states;
  states.reserve(list.pair.size() + list.pair.size() / 8);
  for (const auto& [a, b] : list.pair) {
    add_pair(mesh, candidates_[at(a)].triangle, candidates_[at(b)].triangle, states);
  }
  PairRows rows(states, mesh.triangles());
  carry_over(states, rows);
  states_ = std::move(states);
  rows_ = std::move(rows);
  records_.make_room(states_.size());
  clear_forces();
  loosened_.clear();
  travelled_ = 0.0;
  stale_ = false;
  starts_ = true;
  execution.book("contact search", start);
}

void Contact::carry_over(PairStates& states, const PairRows& rows) {
  for (Index old = 0; old < states_.size(); ++old) {
    const auto [a, b] = states_.triangles(old);
    friction_dissipation_ += states_.loss[at(old)];
    const Index p = rows.find(states, a, b);
    if (p == mesh::none) {
      friction_dissipation_ += states_.stored[at(old)];
      continue;
    }
    states.factor[at(p)] = states_.factor[at(old)];
    states.offset[at(p)] = states_.offset[at(old)];
    states.tangential[at(p)] = states_.tangential[at(old)];
    states.stored[at(p)] = states_.stored[at(old)];
    states.depth[at(p)] = states_.depth[at(old)];
    states.rest[at(p)] = std::max(0.0, states_.rest[at(old)] - travelled_);
    states.start[at(p)] = PairStart::none;
  }
}

void Contact::add_pairs(const mesh::Mesh& mesh, const CornerMotion& motion, Execution& execution) {
  const std::vector<PlacedTriangle> placed = place(mesh, motion, execution);
  const auto start = std::chrono::steady_clock::now();
  std::sort(loosened_.begin(), loosened_.end());
  loosened_.erase(std::unique(loosened_.begin(), loosened_.end()), loosened_.end());
  for (const auto& [a, b] : find_pairs_of(loosened_, candidates_, placed, margin_)) {
    const Index first = candidates_[at(a)].triangle;
    const Index second = candidates_[at(b)].triangle;
    if (rows_.find(states_, first, second) == mesh::none) {
      add_pair(mesh, first, second, states_);
      rows_.insert(states_, states_.size() - 1);
      starts_ = true;
    }
  }
  records_.make_room(states_.size());
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
