// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/execution.hpp"
#include "percolith/simulation/report.hpp"
#include "percolith/simulation/setup.hpp"

#include <chrono>
#include <limits>

namespace percolith::simulation {

/// Tells when the next checkpoint is due, by the time of the simulation and by the clock on the
/// wall.
class CheckpointClock {
public:
  using Wall = std::chrono::steady_clock::time_point;
  /// For a run that starts or goes on at time `t` (s) at the moment `now`.
  CheckpointClock(const Output& output, double t, Wall now);
  [[nodiscard]] bool due(double t, Wall now) const { return t >= next_ || now >= next_wall_; }
  /// A checkpoint of time `t` was written from `start` to `end`. By the wall the next one comes so
  /// late that writing takes a hundredth of the run at most.
  void written(double t, Wall start, Wall end);

private:
  double interval_;       // s; 0: none
  double wall_interval_;  // s; 0: none
  double next_ = std::numeric_limits<double>::infinity();
  Wall next_wall_ = Wall::max();
};

/// Sends checkpoints of a run to its observer.
class Checkpoints {
public:
  /// `state` describes all of the run that later steps, and reports of them, depend on.
  Checkpoints(const Output& output, double t, std::function<void(StateArchive&)> state);

  /// To be called after each step, when all that a run without interruption reports of it has been
  /// reported: sends a checkpoint where one is due or `wanted`.
  void after_step(double time, std::int64_t step, bool wanted, Observer& observer,
                  Execution& execution);

private:
  CheckpointClock clock_;
  std::function<void(StateArchive&)> state_;
};

}  // namespace percolith::simulation
