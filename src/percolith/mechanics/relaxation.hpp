// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/dynamics.hpp"
#include "percolith/mechanics/joined_rock.hpp"

#include <limits>
#include <vector>

namespace percolith::mechanics {

/// Ways to the balance of forces of a rock whose loads stay as they are (theory.md section 25).
/// `pull` is the fast one: corners creep where forces pull them, which levels what differs from
/// one triangle to the next, and every fourth time the rock goes as a whole where its stiffness
/// says. `swing` is the patient one: damped motion, for faces that meet and part by turns.
class Relaxation {
public:
  /// Gives all triangles of `rock`, which must outlive this, masses with which they are stable up
  /// to one and the same step. Time stands still in all that follows.
  explicit Relaxation(Dynamics& rock);

  /// What follows depends on the present state of the rock alone.
  void forget() { joined_.forget(); }
  /// Starts from rest.
  void begin(Execution& execution);
  /// One evaluation of the forces, which leaves `Energies::unbalanced`, and the way from there.
  Changes pull(Execution& execution);
  /// Whether `pull` leads nowhere: forces grow as it goes on, or bonds that give way hold it back.
  [[nodiscard]] bool is_lost() const {
    return (rising_ > patience && unbalanced_ > much_more * least_unbalanced_) ||
           held_back_ > patience;
  }
  /// One step of damped motion.
  Changes swing(Execution& execution);
  /// Leaves the rock at rest where it is.
  void end(Execution& execution) { rock_->halt(execution); }

private:
  static constexpr int patience = 3;
  /// Forces that have grown less than this while a crack goes on may be on their way to where it
  /// stops.
  static constexpr double much_more = 4.0;
  void go_whole(Execution& execution);
  void stay(Execution& execution);
  void read_pull();
  void judge_turn();
  void scale_way(double share);
  [[nodiscard]] double longest_share() const;

  Dynamics* rock_;
  JoinedRock joined_;
  double shortest_joint_ = std::numeric_limits<double>::infinity();  // m
  int turn_ = 0;
  double share_ = 1.0;                  // of the way of the whole rock that is gone
  double unbalanced_ = 0.0;             // N/m, when it went last; 0 at first
  double least_unbalanced_ = 0.0;       // N/m, of the times it went
  int rising_ = 0;                      // times in a row
  int held_back_ = 0;                   // times in a row
  std::vector<double> pull_;            // N/m, x and y per corner slot
  std::vector<double> way_, last_way_;  // m, the same
};

}  // namespace percolith::mechanics
