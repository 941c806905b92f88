// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/solid_task.hpp"

#include "percolith/core/error.hpp"
#include "percolith/simulation/build_model.hpp"
#include "percolith/simulation/checkpoints.hpp"
#include "percolith/simulation/event_clock.hpp"
#include "percolith/simulation/groups.hpp"
#include "percolith/simulation/state.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace percolith::simulation {
namespace {

using mesh::Index;

/// The unbalanced force swings while waves pass: rest is where it is small this often in a row.
constexpr int checks_at_rest = 3;

/// Triangles of the regions of an excavation.
std::vector<Index> triangles_of(const mesh::Mesh& mesh, const std::string& name,
                                const Excavation& excavation) {
  const std::vector<Index> regions =
      find_regions(mesh, excavation.regions, "excavation." + name + ".regions");
  std::vector<Index> triangles;
  for (Index t = 0; t < mesh.triangles(); ++t) {
    if (std::find(regions.begin(), regions.end(), mesh.region[at(t)]) != regions.end()) {
      triangles.push_back(t);
    }
  }
  return triangles;
}

[[noreturn]] void refuse_state(const SolidRun& run) {
  const mechanics::Model& model = run.dynamics.model();
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    for (Index k = 0; k < 3; ++k) {
      const Index c = mesh::corner_of(t, k);
      if (!std::isfinite(model.motion.ux[at(c)]) || !std::isfinite(model.motion.vx[at(c)]) ||
          !std::isfinite(model.motion.uy[at(c)]) || !std::isfinite(model.motion.vy[at(c)])) {
        const Point p = model.mesh.place_of(c);
        throw SolverError(fmt::format(
            "the motion at ({:.6g}, {:.6g}) is not a number at time {:.9g} s (step {}); the "
            "results up to the last output are kept. Look for extreme loads or contradictory "
            "materials near that place, or lower time.safety",
            p.x, p.y, model.motion.time, run.summary.steps));
      }
    }
  }
  throw SolverError(
      fmt::format("the kinetic energy is not a number at time {:.9g} s (step {}); the "
                  "results up to the last output are kept. Lower time.safety",
                  model.motion.time, run.summary.steps));
}

}  // namespace

namespace {

/// Those that ask for the motion of the rock.
std::map<std::string, Probe> probes_in_rock(const Setup& setup) {
  std::map<std::string, Probe> probes = setup.probe;
  std::erase_if(probes, [](const auto& entry) { return entry.second.in == Domain::crack; });
  return probes;
}

/// Of motion in steps of `step` (s) that would take far longer than it must, or than anyone waits.
void warn_of_steps(SolidRun& run, double step) {
  constexpr double many_times = 100.0;
  constexpr double very_many = 1e9;
  const Setup& setup = run.setup;
  if (setup.model.physics == Physics::mechanics && setup.time.step && !run.limits.empty()) {
    const double stable = setup.time.safety * run.limits.back().step;
    if (many_times * *setup.time.step < stable) {
      run.summary.warnings.push_back(fmt::format(
          "time.step = {:g} s is {:.3g} times shorter than the {:.3g} s that are stable, and the "
          "run takes as many times longer. Without time.step the run takes the stable step",
          *setup.time.step, stable / *setup.time.step, stable));
    }
  }
  if (setup.time.end > very_many * step) {
    run.summary.warnings.push_back(fmt::format(
        "time.end = {:g} s takes {:.2g} steps of {:.3g} s, years of computing. Motion is for what "
        "lasts as long as waves in the rock take; for slow injection take time.scheme = "
        "\"quasi_static\"",
        setup.time.end, setup.time.end / step, step));
  }
}

}  // namespace

SolidRun make_solid_run(const Setup& setup, SolidStart start) {
  const mechanics::Model& model = start.dynamics.model();
  ProbePlaces probes = locate_probes(probes_in_rock(setup), model.mesh, {});
  std::vector<mechanics::MotionLimit> limits =
      mechanics::step_limits(model, start.dynamics.contact_penalty());
  const auto joints = model.mesh.joint.size();
  SolidRun run{.setup = setup,
               .dynamics = std::move(start.dynamics),
               .execution = Execution(Backend::host, omp_get_max_threads()),
               .probes = std::move(probes),
               .fracture_names = fracture_table_names(setup),
               .kind_names = joint_kind_names(setup),
               .limits = std::move(limits),
               .added_mass = start.added_mass,
               .broken = {std::vector<std::int32_t>(joints, 0),
                          std::vector<double>(joints, 0.0),
                          std::vector<double>(joints, 0.0),
                          {}},
               .fragments = {},
               .summary = {}};
  run.summary.warnings = solid_warnings(run);
  return run;
}

SolidTask::SolidTask(const Setup& setup, SolidRun run)
    : run_(std::move(run)), clock_(setup.output, setup.time.end),
      history_(setup.output.history_interval.value_or(setup.time.end / 1000.0)) {
  step_ = solid_step(run_);
  if (setup.time.scheme != Scheme::quasi_static) {
    warn_of_steps(run_, step_);
  }
  for (const auto& [name, excavation] : setup.excavation) {
    diggings_.push_back({name, excavation.start, excavation.duration,
                         triangles_of(run_.dynamics.model().mesh, name, excavation),
                         excavation.pressurised ? excavation.pressure : 0.0});
    quiet_after_ = std::max(quiet_after_, excavation.start + excavation.duration);
  }
  std::stable_sort(diggings_.begin(), diggings_.end(),
                   [](const Digging& a, const Digging& b) { return a.start < b.start; });
}

const char* SolidTask::limited_by() const {
  return run_.limits.empty() ? "" : run_.limits.front().mechanism.c_str();
}

double SolidTask::next_break(double t) const {
  return std::min(run_.dynamics.loads().next_break(t), run_.dynamics.supports().next_break(t));
}

Frame SolidTask::frame() const {
  return {time(), run_.summary.steps, solid_matrix_frame(run_), solid_crack_frame(run_)};
}

void SolidTask::require_valid() const {
  if (!std::isfinite(run_.dynamics.model().energy.kinetic)) {
    refuse_state(run_);
  }
}

double SolidTask::next_event(double output) const {
  const double now = time();
  double event = std::min(output, next_break(now));
  if (!diggings_.empty()) {
    event = std::min(event, diggings_.front().start);
  }
  return event;
}

void SolidTask::dig() {
  while (!diggings_.empty() && diggings_.front().start <= time()) {
    take_out(diggings_.front());
    diggings_.erase(diggings_.begin());
    run_.fragments_stale = true;
  }
}

double SolidTask::make_step(double event, Observer& observer) {
  // Steps of equal length reach the event: changes of the step cost accuracy.
  const double way = event - time();
  const double steps = std::max(1.0, std::ceil(way / longest_step() * (1.0 - 1e-9)));
  const double dt = way / steps;
  mechanics::Changes changes = move(dt);
  if (gave_up()) {
    return 0.0;
  }
  if (steps == 1.0) {
    set_time(event);
  }
  for (mechanics::Breakage& breakage : changes.broke) {
    breakage.time = std::min(breakage.time, time());
  }
  ++run_.summary.steps;
  if (changes.any()) {
    observer.on_events(note_events(run_, changes, run_.summary.steps));
  }
  return dt;
}

bool SolidTask::is_at_rest() {
  if (!run_.setup.time.stop_ratio || time() <= quiet_after_ ||
      run_.dynamics.supports().moves(time()) || next_break(time()) < run_.setup.time.end) {
    return false;
  }
  const bool settled = has_settled();
  const bool calm = settled && run_.dynamics.unbalanced_ratio() < *run_.setup.time.stop_ratio;
  calm_checks_ = calm ? calm_checks_ + 1 : 0;
  return calm_checks_ >= checks_at_rest;
}

void SolidTask::report_frame(Observer& observer) {
  const auto start = std::chrono::steady_clock::now();
  if (run_.setup.output.fields) {
    observer.on_frame(frame());
  }
  observer.on_fragments(time(), fragment_rows(run_));
  observer.on_probes(time(), probes());
  run_.execution.book("output", start);
}

void SolidTask::report_history(double step_size, Observer& observer) {
  const auto start = std::chrono::steady_clock::now();
  run_.summary.last = history_row(step_size);
  observer.on_history(run_.summary.last);
  run_.execution.book("output", start);
}

void SolidTask::warn_of_energy(Observer& observer) {
  constexpr double bearable = 0.05;
  const double error = solid_energy_error(run_);
  if (error > bearable) {
    run_.summary.warnings.push_back(
        fmt::format("the energy balance misses {:.2g} of the energy: do not trust the results from "
                    "where residual_J_per_m of history.csv grows; a lower time.safety or some "
                    "damping may help",
                    error));
    observer.on_warning(run_.summary.warnings.back());
  }
}

/// Excavations leave the list in its order: what is still to come is told by their number.
void SolidTask::describe_state(StateArchive& archive) {
  archive("run", run_);
  archive("history", history_);
  archive("calm_checks", calm_checks_);
  std::uint64_t to_come = diggings_.size();
  archive("diggings_to_come", to_come);
  while (diggings_.size() > to_come) {
    diggings_.erase(diggings_.begin());
  }
}

void SolidTask::start_checkpoints() {
  // What there is to tell of the start was told.
  last_ = {.time = time(), .number = run_.summary.steps, .row = true, .frame = true};
  checkpoints_.emplace(run_.setup.output, time(),
                       [this](StateArchive& archive) { describe_state(archive); });
}

void SolidTask::begin(Observer& observer) {
  for (const std::string& warning : run_.summary.warnings) {
    observer.on_warning(warning);
  }
  observer.on_events({});
  report_history(0.0, observer);
  static_cast<void>(history_.due(0.0));
  report_frame(observer);
  start_checkpoints();
}

void SolidTask::begin_from(StateArchive& state, Observer& observer) {
  describe_state(state);
  observer.on_resume(time(), run_.summary.steps);
  start_checkpoints();
}

void SolidTask::make_and_report_step(Observer& observer, const std::function<bool()>& stop) {
  const auto row = [&] { report_history(size_, observer); };
  const auto frame = [&] { report_frame(observer); };
  dig();
  const double output = clock_.next_output(time());
  const double made = make_step(next_event(output), observer);
  if (gave_up()) {
    checkpoints_->report_stop(last_, row, frame, observer, run_.execution);
    last_.stopped = true;
    return;
  }
  size_ = made;
  last_ = end_step(output, stop());
  checkpoints_->report_step(last_, row, frame, observer, run_.execution);
  observer.on_progress({time(), run_.setup.time.end, size_, run_.summary.steps, iterations(),
                        limited_by(), run_.broken.count});
}

Reached SolidTask::advance(Observer& observer, const std::function<bool()>& stop,
                           const Pause& pause) {
  const PauseClock wait(pause, run_.summary.steps);
  listen([&] {
    const coupling::Doing now = doing();
    observer.on_progress({now.time, run_.setup.time.end, size_, run_.summary.steps, iterations(),
                          now.what, run_.broken.count + now.broke});
    return stop();
  });
  last_.stopped = false;
  while (!is_over() && !last_.stopped && !wait.over(time(), run_.summary.steps, last_.frame)) {
    make_and_report_step(observer, stop);
  }
  listen({});
  if (!is_over() && !last_.stopped) {
    return Reached::pause;
  }
  warn_of_energy(observer);
  return is_over() ? Reached::end : Reached::stop;
}

void SolidTask::leave(Observer& observer) {
  checkpoints_->report_stop(
      last_, [&] { report_history(size_, observer); }, [&] { report_frame(observer); }, observer,
      run_.execution);
  warn_of_energy(observer);
}

HistoryRow SolidTask::look() {
  const std::vector<PeakReaction> peaks = run_.summary.peak_reactions;
  const double deepest = run_.deepest_overlap;
  const double throughput = run_.summary.throughput;
  HistoryRow row = history_row(size_);
  run_.summary.peak_reactions = peaks;
  run_.deepest_overlap = deepest;
  run_.summary.throughput = throughput;
  return row;
}

StepEnd SolidTask::end_step(double output, bool stopped) {
  const bool check = run_.summary.steps % steps_between_checks() == 0;
  run_.summary.reached_rest = check && is_at_rest();
  const bool at_output = clock_.reaches(time(), output) || run_.summary.reached_rest;
  if (check || at_output || stopped) {
    require_valid();
  }
  return {time(),
          run_.summary.steps,
          history_.due(time()) || at_output,
          at_output,
          time() >= run_.setup.time.end || run_.summary.reached_rest,
          stopped};
}

std::unique_ptr<Task> make_solid_task(const Setup& setup, const mesh::GmshMesh& mesh,
                                      const StartingMotion& start) {
  require_sensible_intervals(setup);
  SolidStart rock =
      build_solid(setup, mesh, [&](mechanics::Model& model) { set_motion(model, start); });
  return std::make_unique<SolidTask>(setup, make_solid_run(setup, std::move(rock)));
}

}  // namespace percolith::simulation
