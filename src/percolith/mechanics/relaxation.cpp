// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/relaxation.hpp"

#include "percolith/mechanics/step_limit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace percolith::mechanics {
namespace {

/// Evaluations of the forces from one way of the whole rock to the next.
constexpr int turns = 4;
/// The step, to which masses are made; any value would do.
constexpr double step_length = 1e-6;  // s
/// By how much steps stay below the longest stable one of motion, such that the fastest modes
/// decay when the rock creeps, and swing within what local damping leaves stable.
constexpr double safety = 1.5;
constexpr double swing_damping = 0.7;
/// Forces that have lost less than this share call for a new look at the joints.
constexpr double slow = 0.5;
constexpr double smallest_share = 0.01;
constexpr double largest_share = 16.0;
/// Cosine of the angle between two ways below which the second takes back the first.
constexpr double back = -0.25;
/// The same above which the second goes on where the first led.
constexpr double ahead = 0.9;
/// No corner goes further at once than this share of the smallest joint.
constexpr double longest_way = 0.02;
/// Bonds that let less than this share of a way be gone hold the rock back.
constexpr double hampered = 0.25;

double length(std::span<const double> v) {
  return std::sqrt(std::inner_product(v.begin(), v.end(), v.begin(), 0.0));
}

/// As every relaxation leaves it, so that its end need not be gone through again at the next start.
bool is_still(const Motion& motion) {
  const auto none = [](double v) { return v == 0.0; };
  return std::all_of(motion.vx.begin(), motion.vx.end(), none) &&
         std::all_of(motion.vy.begin(), motion.vy.end(), none);
}

}  // namespace

Relaxation::Relaxation(Dynamics& rock)
    : rock_(&rock), joined_(rock.model()), pull_(2 * rock.model().motion.ux.size(), 0.0),
      way_(pull_.size(), 0.0), last_way_(pull_.size(), 0.0) {
  Model& model = rock.model();
  model.damping = {};
  even_masses(model, rock.contact_penalty(), safety * step_length);
  model.damping.local = swing_damping;
  for (Index j = 0; j < model.mesh.joints(); ++j) {
    shortest_joint_ = std::min(shortest_joint_, model.joints.length[at(j)]);
  }
}

void Relaxation::begin(Execution& execution) {
  if (!is_still(rock_->model().motion)) {
    rock_->halt(execution);
  }
  rock_->model().motion.last_step = step_length;
  turn_ = 0;
  share_ = 1.0;
  unbalanced_ = 0.0;
  least_unbalanced_ = std::numeric_limits<double>::infinity();
  rising_ = 0;
  held_back_ = 0;
  std::fill(last_way_.begin(), last_way_.end(), 0.0);
}

Changes Relaxation::pull(Execution& execution) {
  turn_ = (turn_ + 1) % turns;
  if (turn_ != 0) {
    return rock_->creep(step_length, execution);
  }
  Changes changes = rock_->pull(step_length, execution);
  if (changes.any()) {
    stay(execution);
  } else {
    go_whole(execution);
  }
  return changes;
}

/// What broke changes the forces that the way would follow.
void Relaxation::stay(Execution& execution) {
  std::fill(way_.begin(), way_.end(), 0.0);
  rock_->shift(way_, step_length, execution);
}

void Relaxation::go_whole(Execution& execution) {
  const double unbalanced = rock_->model().energy.unbalanced;
  if (unbalanced > slow * unbalanced_) {
    joined_.refresh(rock_->model());
  }
  rising_ = unbalanced_ > 0.0 && unbalanced > unbalanced_ ? rising_ + 1 : 0;
  unbalanced_ = unbalanced;
  least_unbalanced_ = std::min(least_unbalanced_, unbalanced);
  read_pull();
  joined_.find_way(rock_->model(), pull_, way_);
  judge_turn();
  scale_way(share_);
  const double longest = longest_share();
  held_back_ = longest < 1.0 && share_ * longest < hampered ? held_back_ + 1 : 0;
  scale_way(std::min(longest, joined_.share_to_meeting(rock_->model(), way_, unbalanced)));
  rock_->shift(way_, step_length, execution);
}

void Relaxation::scale_way(double share) {
  for (double& w : way_) {
    w *= share;
  }
}

/// Forces from the velocities that they gave masses at rest.
void Relaxation::read_pull() {
  const Model& model = rock_->model();
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    const double w = model.triangles.inverse_mass[at(t)];
    const double force = w > 0.0 ? 1.0 / (w * step_length) : 0.0;
    for (Index k = 0; k < 3; ++k) {
      const auto c = at(mesh::corner_of(t, k));
      pull_[2 * c] = force * model.motion.vx[c];
      pull_[2 * c + 1] = force * model.motion.vy[c];
    }
  }
}

/// Joints that open on one way and shut on the next would go on so for ever; ways that follow each
/// other in one direction are too short, because secants are stiffer than what they stand for.
void Relaxation::judge_turn() {
  const double along = std::inner_product(way_.begin(), way_.end(), last_way_.begin(), 0.0);
  const double both = length(way_) * length(last_way_);
  const bool went_too_far =
      share_ > 1.0 && std::inner_product(pull_.begin(), pull_.end(), last_way_.begin(), 0.0) < 0.0;
  if (along < back * both) {
    share_ = std::max(smallest_share, 0.5 * std::min(1.0, share_));
  } else if (along > ahead * both && rising_ == 0 && !went_too_far) {
    share_ = std::min(largest_share, 1.5 * share_);
  } else {
    share_ = std::min(1.0, 1.5 * share_);
  }
  last_way_ = way_;
}

double Relaxation::longest_share() const {
  double furthest = 0.0;
  for (const double w : way_) {
    furthest = std::max(furthest, std::abs(w));
  }
  const double share = joined_.careful_share(rock_->model(), way_);
  return furthest > 0.0 ? std::min(share, longest_way * shortest_joint_ / furthest) : share;
}

Changes Relaxation::swing(Execution& execution) {
  Model& model = rock_->model();
  const double time = model.motion.time;
  Changes changes = rock_->advance(step_length, execution);
  model.motion.time = time;
  for (Breakage& breakage : changes.broke) {
    breakage.time = time;
  }
  return changes;
}

}  // namespace percolith::mechanics
