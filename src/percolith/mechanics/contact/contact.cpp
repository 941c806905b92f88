// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/contact/contact.hpp"

#include <algorithm>
#include <utility>

namespace percolith::mechanics {
namespace {

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

CornerPlaces undeformed_places(const mesh::Mesh& mesh) {
  CornerPlaces places{std::vector<double>(at(mesh.corners()), 0.0),
                      std::vector<double>(at(mesh.corners()), 0.0)};
  for (Index t = 0; t < mesh.triangles(); ++t) {
    const auto corner = mesh.triangle_points(t);
    for (Index k = 1; k < 3; ++k) {
      const Point from_first = corner[at(k)] - corner[0];
      places.x[at(mesh::corner_of(t, k))] = from_first.x;
      places.y[at(mesh::corner_of(t, k))] = from_first.y;
    }
  }
  return places;
}

/// Triangles with a corner at an end of a joint that broke, and that may touch anything.
std::vector<Index> triangles_at(const mesh::Mesh& mesh, const ContactTopology& topology,
                                std::span<const Index> joints) {
  std::vector<Index> triangles;
  for (const Index j : joints) {
    for (const Index v : mesh.joint[at(j)].vertex) {
      for (const Index corner : mesh.vertex_corners.row(v)) {
        if (const Index t = mesh::triangle_of(corner); topology.candidate[at(t)] != 0) {
          triangles.push_back(t);
        }
      }
    }
  }
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  return triangles;
}

/// Adds up the forces on the triangles of one block, pair by pair in ascending order of partners.
struct Gather {
  const Index* blocks;
  const PairRows* rows;
  const Index* place;  // of the forces of each pair
  const double* force;
  Index triangles;
  double* force_x;
  double* force_y;
  std::uint8_t* acts;

  void operator()(ScalarLane lane) const {
    const Index block = blocks[lane.first];
    std::array<double, mesh::corners_per_block> x{};
    std::array<double, mesh::corners_per_block> y{};
    bool act = false;
    const Index end = std::min(block_width, triangles - block * block_width);
    for (Index k = 0; k < end; ++k) {
      act = add(rows->row(block * block_width + k), x.data() + k, y.data() + k) || act;
    }
    if (!act && acts[block] == 0) {
      return;
    }
    acts[block] = act ? 1 : 0;
    const Index slot = block * mesh::corners_per_block;
    std::copy(x.begin(), x.end(), force_x + slot);
    std::copy(y.begin(), y.end(), force_y + slot);
  }

private:
  /// False where no pair of the row touches.
  bool add(std::span<const Index> row, double* x, double* y) const {
    bool any = false;
    std::array<double, 6> sum{};
    constexpr std::size_t most = 32;
    std::array<Index, most> found;
    while (!row.empty()) {
      // Those that touch are picked first: which they are cannot be foretold.
      const auto part = row.first(std::min(row.size(), most));
      std::size_t count = 0;
      for (const Index entry : part) {
        const Index p = place[pair_of(entry)];
        found[count] = p + side_of(entry) * PairForceBlock::side;
        count += p != mesh::none ? 1 : 0;
      }
      for (std::size_t i = 0; i < count; ++i) {
        const double* from = force + found[i];
        for (std::size_t c = 0; c < sum.size(); ++c) {
          sum[c] += from[c * block_width];
        }
      }
      any = any || count > 0;
      row = row.subspan(part.size());
    }
    for (std::size_t k = 0; k < 3; ++k) {
      x[k * block_width] = sum[k];
      y[k * block_width] = sum[3 + k];
    }
    return any;
  }
};

/// Faces that have slid apart by a share of their length need so much more of the overlap that is
/// left to press as before; what is beyond would be too stiff for the step.
constexpr double play = 1.25;

}  // namespace

Contact::Contact(const mesh::Mesh& mesh, ContactProperties properties)
    : properties_(std::move(properties)), triangle_joints_(joints_of_triangles(mesh)),
      undeformed_(undeformed_places(mesh)), force_x_(at(mesh.corners()), 0.0),
      force_y_(at(mesh.corners()), 0.0), acts_(at(padded(mesh.triangles()) / block_width), 0) {}

void Contact::topology_changed(const mesh::Mesh& mesh, const ContactTopology& topology,
                               std::span<const Index> broken) {
  const auto candidate = [&](Index t) {
    return make_candidate(mesh, topology, triangle_joints_[at(t)], t);
  };
  if (broken.empty()) {
    candidates_.clear();
    for (Index t = 0; t < mesh.triangles(); ++t) {
      if (topology.candidate[at(t)] != 0) {
        candidates_.push_back(candidate(t));
      }
    }
    stale_ = true;
  } else {
    const std::vector<Index> loosened = triangles_at(mesh, topology, broken);
    std::vector<Candidate> changed;
    changed.reserve(loosened.size());
    for (const Index t : loosened) {
      changed.push_back(candidate(t));
    }
    merge_candidates(changed, candidates_);
    loosened_.insert(loosened_.end(), loosened.begin(), loosened.end());
  }
  set_blocks();
}

void Contact::set_blocks() {
  blocks_.clear();
  for (const Candidate& c : candidates_) {
    if (blocks_.empty() || blocks_.back() != c.triangle / block_width) {
      blocks_.push_back(c.triangle / block_width);
    }
  }
}

void Contact::hand_over(const mesh::Mesh& mesh, const HandOver& start) {
  const auto& sides = mesh.joint[at(start.joint)].corner;
  const Index a = mesh::triangle_of(sides[0][0]);
  const Index b = mesh::triangle_of(sides[1][0]);
  // Two faces that overlap by d press with 3 p d (1/height_a + 1/height_b) per area.
  const double penalty = in_series(properties_.penalty[at(a)], properties_.penalty[at(b)]);
  const double slope =
      1.5 * penalty * mesh.joint_length(start.joint) * (1.0 / mesh.area(a) + 1.0 / mesh.area(b));
  pending_.push_back({{a, b}, start, play * std::max(1.0, start.stiffness / slope)});
}

void Contact::apply_hand_overs() {
  handed_.clear();
  for (const PendingHandOver& pending : pending_) {
    const Index p = rows_.find(states_, pending.triangle[0], pending.triangle[1]);
    if (p != mesh::none) {
      handed_.push_back(
          {p, pending.start.normal_force, pending.start.shear_on_first, pending.largest_factor});
      states_.start[at(p)] = PairStart::handed;
      states_.rest[at(p)] = 0.0;
      starts_ = true;
    }
  }
  pending_.clear();
  std::stable_sort(handed_.begin(), handed_.end(),
                   [](const PairHandOver& a, const PairHandOver& b) { return a.pair < b.pair; });
}

void Contact::advance(const mesh::Mesh& mesh, const CornerMotion& motion, double travelled,
                      double dt, Execution& execution) {
  for (const Index corner : added_) {
    force_x_[at(corner)] = 0.0;
    force_y_[at(corner)] = 0.0;
  }
  added_.clear();
  if (candidates_.empty() && !stale_) {
    return;
  }
  travelled_ += travelled;
  if (stale_ || travelled_ > 0.5 * margin_) {
    search(mesh, motion, execution);
  } else if (!loosened_.empty()) {
    add_pairs(mesh, motion, execution);
  }
  apply_hand_overs();
  std::vector<Index> new_pairs;
  for (Index p = 0; starts_ && p < states_.size(); ++p) {
    if (states_.start[at(p)] != PairStart::none) {
      new_pairs.push_back(p);
    }
  }
  execution.for_each_chunk(
      "contact force", states_.size(), pair_chunk,
      PairForces{&states_, forces_.data(), &undeformed_, motion, handed_, travelled_, dt, starts_});
  starts_ = false;
  for (const Index p : new_pairs) {
    if (states_.state[at(p)].offset > 0.0) {
      states_.origin[at(p)] = overlap_of_pair(mesh, motion, p);
    }
  }
  if (forces_.empty()) {
    return;
  }
  execution.for_each("contact force", static_cast<Index>(blocks_.size()),
                     Gather{blocks_.data(), &rows_, states_.force.data(),
                            forces_.front().value.data(), mesh.triangles(), force_x_.data(),
                            force_y_.data(), acts_.data()});
}

void Contact::add_force(Index corner, const Point& force) {
  force_x_[at(corner)] += force.x;
  force_y_[at(corner)] += force.y;
  acts_[at(mesh::triangle_of(corner) / block_width)] = 1;
  added_.push_back(corner);
}

}  // namespace percolith::mechanics
