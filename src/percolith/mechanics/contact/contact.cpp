// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/contact/contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace percolith::mechanics {
namespace {

// Of the mean edge of the candidates: a wider margin means fewer searches, but more pairs.
constexpr double margin_share = 0.2;

Candidate make_candidate(const mesh::Mesh& mesh, const ContactTopology& topology,
                         std::span<const Index> joints, Index triangle) {
  Candidate candidate;
  candidate.triangle = triangle;
  for (std::size_t k = 0; k < 3; ++k) {
    candidate.leader[k] = topology.fans->leader(mesh::corner_of(triangle, static_cast<Index>(k)));
    candidate.neighbour[k] = mesh::none;
    if (const Index j = joints[k]; j != mesh::none) {
      const auto& sides = mesh.joint[at(j)].corner;
      const Index first = mesh::triangle_of(sides[0][0]);
      candidate.neighbour[k] = first == triangle ? mesh::triangle_of(sides[1][0]) : first;
      candidate.neighbour_touch[k] = topology.faces_touch[at(j)];
    }
  }
  return candidate;
}

/// Brings what the corner slots hold into one place for each candidate.
struct Place {
  const mesh::Mesh* mesh;
  const CornerMotion* motion;
  const Candidate* candidate;
  PlacedTriangle* placed;
  CornerVelocities* velocity;

  void operator()(ScalarLane lane) const {
    const auto i = at(lane.first);
    const Index triangle = candidate[i].triangle;
    const auto& vertices = mesh->triangle_vertex[at(triangle)];
    std::array<Point, 3> x;
    std::array<Point, 3> u;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto slot = at(mesh::corner_of(triangle, static_cast<Index>(k)));
      x[k] = mesh->vertex[at(vertices[k])];
      u[k] = {motion->ux[slot], motion->uy[slot]};
      velocity[i][k] = {motion->vx[slot], motion->vy[slot]};
    }
    placed[i] = {x[0], u[0], (x[1] - x[0]) + (u[1] - u[0]), (x[2] - x[0]) + (u[2] - u[0])};
  }
};

/// Adds up the forces on the candidates of one block, pair by pair in ascending order.
struct Gather {
  const Index* block_start;
  const Candidate* candidate;
  const PairList* list;
  const PairStates* pairs;
  double* force_x;
  double* force_y;
  std::uint8_t* acts;

  void operator()(ScalarLane lane) const {
    const Index first = block_start[lane.first];
    const Index end = block_start[lane.first + 1];
    const Index block = candidate[first].triangle / block_width;
    std::array<Point, mesh::corners_per_block> sum{};  // as the slots of the block
    bool act = false;
    for (Index c = first; c < end; ++c) {
      Point* const own = sum.data() + candidate[c].triangle % block_width;
      for (const Index p : list->as_second.row(c)) {
        act = add(at(p), 1, own) || act;
      }
      for (Index p = list->start[at(c)]; p < list->start[at(c) + 1]; ++p) {
        act = add(at(p), 0, own) || act;
      }
    }
    if (!act && acts[block] == 0) {
      return;
    }
    acts[block] = act ? 1 : 0;
    const Index slot = block * mesh::corners_per_block;
    for (Index k = 0; k < mesh::corners_per_block; ++k) {
      force_x[slot + k] = sum[at(k)].x;
      force_y[slot + k] = sum[at(k)].y;
    }
  }

private:
  /// False where the pair does not touch.
  bool add(std::size_t pair, std::size_t side, Point* sum) const {
    if (pairs->touching[pair] == 0) {
      return false;
    }
    const auto& force = pairs->force[pair][side];
    for (std::size_t k = 0; k < 3; ++k) {
      Point& corner = sum[k * block_width];
      corner = corner + force[k];
    }
    return true;
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

Contact::Contact(const mesh::Mesh& mesh, ContactProperties properties)
    : properties_(std::move(properties)), triangle_joints_(joints_of_triangles(mesh)),
      force_x_(at(mesh.corners()), 0.0), force_y_(at(mesh.corners()), 0.0),
      acts_(at(padded(mesh.triangles()) / block_width), 0) {}

void Contact::topology_changed(const mesh::Mesh& mesh, const ContactTopology& topology) {
  candidates_.clear();
  surface_.clear();
  block_start_.clear();
  for (Index t = 0; t < mesh.triangles(); ++t) {
    if (topology.candidate[at(t)] == 0) {
      continue;
    }
    if (candidates_.empty() || candidates_.back().triangle / block_width != t / block_width) {
      block_start_.push_back(static_cast<Index>(candidates_.size()));
    }
    candidates_.push_back(make_candidate(mesh, topology, triangle_joints_[at(t)], t));
    surface_.push_back({properties_.penalty[at(t)], properties_.tangential_penalty[at(t)],
                        properties_.friction[at(t)], 2.0 * mesh.area(t)});
  }
  block_start_.push_back(static_cast<Index>(candidates_.size()));
  placed_.resize(candidates_.size());
  velocity_.resize(candidates_.size());
  stale_ = true;
}

void Contact::hand_over(const mesh::Mesh& mesh, const HandOver& start) {
  const auto& sides = mesh.joint[at(start.joint)].corner;
  pending_.push_back({{mesh::triangle_of(sides[0][0]), mesh::triangle_of(sides[1][0])}, start});
}

void Contact::place(const mesh::Mesh& mesh, const CornerMotion& motion, Execution& execution) {
  execution.for_each("contact force", static_cast<Index>(candidates_.size()),
                     Place{&mesh, &motion, candidates_.data(), placed_.data(), velocity_.data()});
}

void Contact::search(Execution& execution) {
  margin_ = margin_share * mean_edge(placed_);
  PairList list = find_pairs(candidates_, placed_, margin_, execution);
  PairStates states;
  states.resize(list.pair.size());
  carry_over(list, states);
  list_ = std::move(list);
  pairs_ = std::move(states);
  clear_forces();
  searched_.clear();
  for (const Candidate& c : candidates_) {
    searched_.push_back(c.triangle);
  }
  travelled_ = 0.0;
  stale_ = false;
}

void Contact::carry_over(const PairList& list, PairStates& states) {
  std::size_t next = 0;
  for (std::size_t old = 0; old < list_.pair.size(); ++old) {
    const std::array<Index, 2> key{searched_[at(list_.pair[old][0])],
                                   searched_[at(list_.pair[old][1])]};
    const auto triangles = [&](std::size_t p) {
      return std::array<Index, 2>{candidates_[at(list.pair[p][0])].triangle,
                                  candidates_[at(list.pair[p][1])].triangle};
    };
    while (next < list.pair.size() && triangles(next) < key) {
      ++next;
    }
    if (next < list.pair.size() && triangles(next) == key) {
      states.state[next] = pairs_.state[old];
      states.touching[next] = pairs_.touching[old];
      states.edge[next] = pairs_.edge[old];
      states.start[next] = PairStart::none;
      states.state[next].loss = 0.0;
    } else {
      friction_dissipation_ += stored_energy(pairs_.state[old]);
    }
    friction_dissipation_ += pairs_.state[old].loss;
  }
}

void Contact::clear_forces() {
  std::vector<std::uint8_t> searched(acts_.size(), 0);
  for (const Candidate& c : candidates_) {
    searched[at(c.triangle / block_width)] = 1;
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

void Contact::apply_hand_overs() {
  handed_.clear();
  for (const PendingHandOver& pending : pending_) {
    const auto number = [&](Index triangle) {
      return static_cast<Index>(std::lower_bound(searched_.begin(), searched_.end(), triangle) -
                                searched_.begin());
    };
    const std::array<Index, 2> wanted{number(pending.triangle[0]), number(pending.triangle[1])};
    const auto found = std::lower_bound(list_.pair.begin(), list_.pair.end(), wanted);
    const bool listed = found != list_.pair.end() &&
                        searched_[at((*found)[0])] == pending.triangle[0] &&
                        searched_[at((*found)[1])] == pending.triangle[1];
    if (listed) {
      const auto p = static_cast<Index>(found - list_.pair.begin());
      handed_.push_back({p, pending.start.normal_force, pending.start.shear_on_first});
      pairs_.start[at(p)] = PairStart::handed;
    }
  }
  pending_.clear();
  std::stable_sort(handed_.begin(), handed_.end(),
                   [](const PairHandOver& a, const PairHandOver& b) { return a.pair < b.pair; });
}

void Contact::advance(const mesh::Mesh& mesh, const CornerMotion& motion, double travelled,
                      double dt, Execution& execution) {
  if (candidates_.empty() && !stale_) {
    return;
  }
  travelled_ += travelled;
  place(mesh, motion, execution);
  if (stale_ || travelled_ > 0.5 * margin_) {
    search(execution);
  }
  apply_hand_overs();
  if (!list_.pair.empty()) {
    const auto count = static_cast<Index>(list_.pair.size());
    execution.for_each("contact force", count,
                       PairForceKernel{list_.pair.data(), placed_.data(), surface_.data(),
                                       velocity_.data(), handed_, dt, &pairs_});
  }
  gather(execution);
}

void Contact::gather(Execution& execution) {
  execution.for_each("contact force", static_cast<Index>(block_start_.size()) - 1,
                     Gather{block_start_.data(), candidates_.data(), &list_, &pairs_,
                            force_x_.data(), force_y_.data(), acts_.data()});
}

}  // namespace percolith::mechanics
