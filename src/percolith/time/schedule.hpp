// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/archive.hpp"

#include <vector>

namespace percolith {

/// How a schedule runs between its entries: straight lines, or the value of the last entry.
enum class Interpolation { linear, step };

/// A quantity that depends on time: a constant (one entry) or a table. Before the first and after
/// the last entry it keeps their values. Times (s) strictly increase; values are SI.
struct Schedule {
  std::vector<double> time{0.0};
  std::vector<double> value{0.0};
  Interpolation interpolation = Interpolation::linear;

  /// The schedule that is `value` at all times.
  [[nodiscard]] static Schedule constant(double value);
  /// Value at time `t` (s).
  [[nodiscard]] double at(double t) const;
  /// The first time after `t` at which the slope or the value jumps; infinity when there is none.
  [[nodiscard]] double next_break(double t) const;
  /// The value of largest magnitude that it comes to.
  [[nodiscard]] double largest() const;
  [[nodiscard]] bool is_constant() const { return value.size() == 1; }
  friend bool operator==(const Schedule&, const Schedule&) = default;
};

void describe_state(StateArchive& archive, Schedule& schedule);

}  // namespace percolith
