// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/archive.hpp"
#include "percolith/coupling/doing.hpp"
#include "percolith/simulation/checkpoints.hpp"
#include "percolith/simulation/event_clock.hpp"
#include "percolith/simulation/solid_run.hpp"
#include "percolith/simulation/task.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace percolith::simulation {

/// An excavation that is still to come.
struct Digging {
  std::string name;                    ///< of its table
  double start = 0.0;                  ///< s
  double duration = 0.0;               ///< s
  std::vector<mesh::Index> triangles;  ///< that are taken out
  double pressure = 0.0;               ///< Pa, on the rock of the walls they leave
};

/// A rock ready to move, and the loop over its steps, outputs and history. Physics that adds to the
/// motion of a dry rock overrides how a step is made and what is told of it.
class SolidTask : public Task {
public:
  SolidTask(const Setup& setup, SolidRun run);

  [[nodiscard]] CheckReport check() const override { return solid_check(run_); }
  void begin(Observer& observer) override;
  void begin_from(StateArchive& state, Observer& observer) override;
  Reached advance(Observer& observer, const std::function<bool()>& stop,
                  const Pause& pause) override;
  void leave(Observer& observer) override;
  [[nodiscard]] Frame frame() const override;
  [[nodiscard]] std::vector<ProbeSample> probes() const override { return read_solid_probes(run_); }
  [[nodiscard]] HistoryRow look() override;
  [[nodiscard]] double time() const override { return run_.dynamics.model().motion.time; }
  [[nodiscard]] std::int64_t steps() const override { return run_.summary.steps; }
  [[nodiscard]] const mechanics::Model* motion() const override { return &run_.dynamics.model(); }
  [[nodiscard]] Summary summary() const override { return solid_summary(run_); }
  [[nodiscard]] const std::vector<std::string>& region_names() const override {
    return run_.dynamics.model().mesh.region_names;
  }
  [[nodiscard]] const std::vector<std::string>& fracture_names() const override {
    return run_.fracture_names;
  }

protected:
  /// One step of `dt` seconds.
  virtual mechanics::Changes move(double dt) { return run_.dynamics.advance(dt, run_.execution); }
  /// A step that takes long may ask `stop` on its way and give up, which leaves all as it was.
  virtual void listen(const std::function<bool()>& /*stop*/) {}
  /// What a step is at, to be asked from `stop`.
  [[nodiscard]] virtual coupling::Doing doing() const { return {}; }
  [[nodiscard]] virtual bool gave_up() const { return false; }
  /// Steps after which the state is looked at for values that are none.
  [[nodiscard]] virtual std::int64_t steps_between_checks() const { return 200; }
  /// Longest step that may be taken now, s.
  [[nodiscard]] virtual double longest_step() const { return step_; }
  /// What rules that step.
  [[nodiscard]] virtual const char* limited_by() const;
  /// The first time after `t` at which something from outside jumps or bends, s.
  [[nodiscard]] virtual double next_break(double t) const;
  /// Takes out what an excavation says.
  virtual void take_out(const Digging& digging) {
    run_.dynamics.take_out(digging.triangles, digging.duration, digging.pressure);
  }
  /// Whether all but the rock has come to rest since this was asked last.
  virtual bool has_settled() { return true; }
  /// Puts the clock on `t` (s), from which it differs by round-off.
  virtual void set_time(double t) { run_.dynamics.model().motion.time = t; }
  virtual HistoryRow history_row(double step_size) { return solid_history_row(run_, step_size); }
  /// All that later steps, and reports of them, depend on.
  virtual void describe_state(StateArchive& archive);
  /// Throws SolverError where the state is no longer one of numbers.
  virtual void require_valid() const;
  [[nodiscard]] virtual std::int64_t iterations() const { return 0; }

  SolidRun run_;
  double step_ = 0.0;              // s, at most
  std::vector<Digging> diggings_;  // that are still to come, by time

private:
  [[nodiscard]] double next_event(double output) const;
  void start_checkpoints();
  [[nodiscard]] bool is_over() const {
    return time() >= run_.setup.time.end || run_.summary.reached_rest;
  }
  void make_and_report_step(Observer& observer, const std::function<bool()>& stop);
  [[nodiscard]] StepEnd end_step(double output, bool stopped);
  void dig();
  double make_step(double event, Observer& observer);
  bool is_at_rest();
  void warn_of_energy(Observer& observer);
  void report_frame(Observer& observer);
  void report_history(double step_size, Observer& observer);

  double quiet_after_ = 0.0;  // s: no load changes later
  int calm_checks_ = 0;
  EventClock clock_;
  HistoryClock history_;
  std::optional<Checkpoints> checkpoints_;
  StepEnd last_;       // the last step
  double size_ = 0.0;  // s: of it
};

/// A rock that is ready to move, `start`, with what reports need of it.
[[nodiscard]] SolidRun make_solid_run(const Setup& setup, SolidStart start);

}  // namespace percolith::simulation
