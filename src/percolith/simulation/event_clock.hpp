// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/archive.hpp"
#include "percolith/simulation/setup.hpp"

#include <limits>

namespace percolith::simulation {

/// Throws InputError when an output or history interval would give more than a million outputs.
void require_sensible_intervals(const Setup& setup);

/// The times at which fields and probes are written.
class EventClock {
public:
  /// Output times up to `end`; the end itself is always one.
  EventClock(const Output& output, double end);
  /// The first output time after `t`, s; infinity after the last.
  [[nodiscard]] double next_output(double t) const;
  /// True when `t` is the output time `output` or differs from it by round-off.
  [[nodiscard]] bool reaches(double t, double output) const;

private:
  std::vector<double> times_;  // of the list and the end, ascending
  double interval_;            // 0: none
};

/// Tells when the next row of history is due.
class HistoryClock {
public:
  /// Rows `interval` s apart, or on every call where it is zero.
  explicit HistoryClock(double interval) : interval_(interval) {}
  [[nodiscard]] bool due(double t);
  void describe_state(StateArchive& archive) { archive("next", next_); }

private:
  double interval_;
  double next_ = -std::numeric_limits<double>::infinity();
};

}  // namespace percolith::simulation
