// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace percolith::coupling {

/// How an iteration comes nearer to the pressures it looks for, each change of them being what the
/// fluid that finds no room makes up with the compliance s C of the rock, C its estimate. Changes
/// d1 with s1 and d2 with s2 after it tell the true factor s of a rock with one kind of answer:
/// s2 d2 = s1 d1 (1 - s/s1).
class Approach {
public:
  /// An iteration with the factor `softness` that led from the pressures `before` to `now`, Pa;
  /// entries from `first` on, or all where there are none, are compared with the change before.
  void see(const std::vector<double>& before, const std::vector<double>& now, std::size_t first,
           double softness);
  /// What comes next has nothing to do with what was before.
  void forget() { last_.clear(); }

  /// The true factor s by the last two iterations; not positive where they lead away.
  [[nodiscard]] std::optional<double> softness() const { return found_; }
  /// How far the pressures before the last iteration were from those looked for, over the largest:
  /// an iteration that creeps, its factor too large, is not at its end because its changes are
  /// small.
  [[nodiscard]] double distance() const;

private:
  std::vector<double> last_;  // Pa, change
  double used_ = 1.0;         // s of it
  double change_ = 0.0;       // the largest of it, over the largest pressure
  std::optional<double> found_;
};

}  // namespace percolith::coupling
