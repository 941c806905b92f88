// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/checkpoints.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace percolith::simulation {
namespace {

/// Time that writing checkpoints may take, over that of the run.
constexpr double bearable_share = 0.01;

double next_multiple(double t, double interval) {
  return interval * (std::floor(t / interval * (1.0 + 1e-12)) + 1.0);
}

CheckpointClock::Wall later(CheckpointClock::Wall wall, double seconds) {
  // Far enough away to be never, near enough to be counted in the ticks of the clock.
  constexpr double never = 3e8;
  return wall + std::chrono::duration_cast<CheckpointClock::Wall::duration>(
                    std::chrono::duration<double>(std::min(seconds, never)));
}

}  // namespace

CheckpointClock::CheckpointClock(const Output& output, double t, Wall now)
    : interval_(output.checkpoint_interval.value_or(0.0)),
      wall_interval_(output.checkpoint_wall_interval) {
  written(t, now, now);
}

void CheckpointClock::written(double t, Wall start, Wall end) {
  if (interval_ > 0.0) {
    next_ = next_multiple(t, interval_);
  }
  if (wall_interval_ > 0.0) {
    const double taken = std::chrono::duration<double>(end - start).count();
    next_wall_ = later(end, std::max(wall_interval_, taken / bearable_share));
  }
}

Checkpoints::Checkpoints(const Output& output, double t, std::function<void(StateArchive&)> state)
    : clock_(output, t, std::chrono::steady_clock::now()), state_(std::move(state)) {}

void Checkpoints::report_step(const StepEnd& step, const std::function<void()>& row,
                              const std::function<void()>& frame, Observer& observer,
                              Execution& execution) {
  if (step.row) {
    row();
  }
  if (step.frame) {
    frame();
  }
  if (!step.last) {
    send(step, observer, execution);
  }
  if (step.stopped && !step.row) {
    row();
  }
  if (step.stopped && !step.frame) {
    frame();
  }
}

void Checkpoints::report_stop(StepEnd last, const std::function<void()>& row,
                              const std::function<void()>& frame, Observer& observer,
                              Execution& execution) {
  last.stopped = true;
  send(last, observer, execution);
  if (!last.row) {
    row();
  }
  if (!last.frame) {
    frame();
  }
}

void Checkpoints::send(const StepEnd& step, Observer& observer, Execution& execution) {
  const auto start = std::chrono::steady_clock::now();
  if (!step.stopped && !clock_.due(step.time, start)) {
    return;
  }
  observer.on_checkpoint({step.time, step.number, state_});
  clock_.written(step.time, start, std::chrono::steady_clock::now());
  execution.book("checkpoint", start);
}

}  // namespace percolith::simulation
