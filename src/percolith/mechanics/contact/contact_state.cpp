// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/archive.hpp"
#include "percolith/mechanics/contact/contact.hpp"

// The pairs are kept as they are listed, because sums run in the order of the list and a list that
// was searched anew holds other pairs: those within the margin of where the triangles are now.
namespace percolith::mechanics {

static void describe_state(StateArchive& archive, Candidate& candidate) {
  archive("triangle", candidate.triangle);
  archive("leader", candidate.leader);
  archive("neighbour", candidate.neighbour);
  archive("neighbour_touch", candidate.neighbour_touch);
}

static void describe_state(StateArchive& archive, PairNature& nature) {
  archive("apart", nature.apart);
  archive("stiffness", nature.stiffness);
  archive("tangential_penalty", nature.tangential_penalty);
  archive("friction", nature.friction);
  archive("slot", nature.slot);
}

static void describe_state(StateArchive& archive, PairState<double>& state) {
  archive("factor", state.factor);
  archive("offset", state.offset);
  archive("tangential", state.tangential);
  archive("stored", state.stored);
  archive("loss", state.loss);
  archive("depth", state.depth);
}

static void describe_state(StateArchive& archive, PairOrigin& origin) {
  archive("energy", origin.energy);
  archive("force", origin.force);
}

static void describe_state(StateArchive& archive, PairStates& states) {
  archive.of_any_size("nature", states.nature);
  archive.of_any_size("state", states.state);
  archive.of_any_size("origin", states.origin);
  archive.of_any_size("start", states.start);
  archive.of_any_size("rest", states.rest);
  archive.of_any_size("force", states.force);
}

static void describe_state(StateArchive& archive, HandOver& start) {
  archive("joint", start.joint);
  archive("normal_force", start.normal_force);
  archive("shear_on_first", start.shear_on_first);
  archive("stiffness", start.stiffness);
}

void PairRows::Row::describe_state(StateArchive& archive) {
  archive("start", start);
  archive("count", count);
  archive("room", room);
}

void PairRows::describe_state(StateArchive& archive) {
  archive.of_any_size("rows", rows_);
  archive.of_any_size("entries", entries_);
}

void Contact::PendingHandOver::describe_state(StateArchive& archive) {
  archive("triangle", triangle);
  archive("start", start);
  archive("largest_factor", largest_factor);
}

/// Of the forces on the pairs only those in use, which an excavation may release before they are
/// worked out anew.
void Contact::describe_pair_forces(StateArchive& archive) {
  std::vector<std::array<double, 12>> used;
  const auto for_each_used = [&](const auto& visit) {
    std::size_t k = 0;
    for (const Index place : states_.force) {
      if (place != mesh::none) {
        double* force = forces_.front().value.data() + place;
        for (Index i = 0; i < 6; ++i) {
          visit(force[i * block_width], force[PairForceBlock::side + i * block_width], k, at(i));
        }
        ++k;
      }
    }
  };
  std::uint64_t blocks = forces_.size();
  archive("force_blocks", blocks);
  used.resize(at(touching_pairs()));
  if (!archive.reads()) {
    for_each_used([&](double first, double second, std::size_t k, std::size_t i) {
      used[k][i] = first;
      used[k][6 + i] = second;
    });
  }
  archive("pair_forces", used);
  if (archive.reads()) {
    forces_.resize(blocks);
    make_room();
    for_each_used([&](double& first, double& second, std::size_t k, std::size_t i) {
      first = used[k][i];
      second = used[k][6 + i];
    });
  }
}

void Contact::describe_state(StateArchive& archive) {
  archive.of_any_size("candidates", candidates_);
  archive.of_any_size("loosened", loosened_);
  archive("pairs", states_);
  archive("rows", rows_);
  describe_pair_forces(archive);
  archive.of_any_size("pending", pending_);
  archive("stale", stale_);
  archive("starts", starts_);
  archive("margin", margin_);
  archive("travelled", travelled_);
  archive("friction_dissipation", friction_dissipation_);
  archive("force_x", force_x_);
  archive("force_y", force_y_);
  archive.of_any_size("added", added_);
  archive("acts", acts_);
  if (archive.reads()) {
    set_blocks();
  }
}

}  // namespace percolith::mechanics
