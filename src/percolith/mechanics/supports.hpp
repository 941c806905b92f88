// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/model.hpp"
#include "percolith/time/schedule.hpp"

#include <array>
#include <string>
#include <vector>

namespace percolith::mechanics {

/// A motion that is prescribed along directions: a velocity, or a displacement that is turned into
/// the velocity which reaches it at the end of the step.
struct PrescribedMotion {
  enum class Kind { velocity, displacement };
  std::string name;  ///< of the table that prescribes it, for reactions and messages
  Kind kind = Kind::velocity;
  Schedule value;  ///< m/s or m
};

/// One direction along which a corner, and with it its node, moves as prescribed.
struct Held {
  Index corner = 0;
  Point direction;   ///< unit vector
  Index motion = 0;  ///< index of the prescribed motions
};

/// Corners held along at most two directions each.
class SupportSet {
public:
  SupportSet() = default;
  /// Throws InputError when a corner is held along the same direction by two motions that are not
  /// the same, or along three different directions by motions other than rest.
  SupportSet(Model& model, std::vector<PrescribedMotion> motions, std::vector<Held> held);

  /// Sets the prescribed velocities for a step of `dt` (s) from the model's present time.
  void apply(Model& model, double dt) const;
  [[nodiscard]] double next_break(double t) const;
  /// Whether anything is moved by a velocity that is not zero at time `t` (s).
  [[nodiscard]] bool moves(double t) const;

  [[nodiscard]] const std::vector<PrescribedMotion>& motions() const { return motions_; }
  /// Sum of the forces (N/m) with which each table's supports acted on the rock in the last step,
  /// by the order of `tables()`. Where two tables hold a corner along two directions, the force
  /// along each counts for its own.
  [[nodiscard]] std::vector<Point> reactions(const Model& model) const;
  /// Mean displacement (m) of the corners of each table.
  [[nodiscard]] std::vector<Point> displacements(const Model& model) const;
  [[nodiscard]] const std::vector<std::string>& tables() const { return tables_; }

private:
  /// A corner with its place in the records and how its velocity follows from the motions.
  struct Entry {
    Index corner = 0;
    Index place = 0;
    std::array<Index, 2> table{mesh::none, mesh::none};
    std::array<Index, 2> motion{mesh::none, mesh::none};
    std::array<Point, 2> direction{};
    std::array<Point, 2> along{};  // velocity of the corner per prescribed velocity
  };
  void add_corner(Model& model, std::span<const Held> held);
  std::vector<PrescribedMotion> motions_;
  std::vector<std::string> tables_;
  std::vector<Entry> entries_;
  bool at_rest_ = true;
};

}  // namespace percolith::mechanics
