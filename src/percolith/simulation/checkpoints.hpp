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

/// A step that was made, and what a run without interruption reports of it.
struct StepEnd {
  double time = 0.0;  ///< s
  std::int64_t number = 0;
  bool row = false;      ///< of the history
  bool frame = false;    ///< and probes
  bool last = false;     ///< the run has come to its end
  bool stopped = false;  ///< the run is asked to stop here
};

/// Sends checkpoints of a run to its observer.
class Checkpoints {
public:
  /// `state` describes all of the run that later steps, and reports of them, depend on.
  Checkpoints(const Output& output, double t, std::function<void(StateArchive&)> state);

  /// Calls `row` and `frame`, which report them, where the step says so; then sends a checkpoint
  /// where one is due or the run stops before its end. A run that stops reports a row and a frame
  /// in any case, but after the checkpoint: what goes on from it knows nothing of them.
  void report_step(const StepEnd& step, const std::function<void()>& row,
                   const std::function<void()>& frame, Observer& observer, Execution& execution);

  /// For a run that stops in the midst of the step after `last`, which was reported.
  void report_stop(StepEnd last, const std::function<void()>& row,
                   const std::function<void()>& frame, Observer& observer, Execution& execution);

private:
  void send(const StepEnd& step, Observer& observer, Execution& execution);

  CheckpointClock clock_;
  std::function<void(StateArchive&)> state_;
};

}  // namespace percolith::simulation
