// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/steady_flow.hpp"
#include "percolith/simulation/balance.hpp"
#include "percolith/simulation/build_model.hpp"
#include "percolith/simulation/check_report.hpp"
#include "percolith/simulation/run.hpp"
#include "percolith/simulation/task.hpp"

#include <omp.h>

#include <optional>
#include <utility>

namespace percolith::simulation {
namespace {

/// A model without state to run, and what it needs to run.
RunState make_run(const Setup& setup, const mesh::GmshMesh& mesh) {
  require_sensible_intervals(setup);
  seepage::Model model = build_model(setup, mesh);
  require_datum(setup, model);
  ProbeReader probes(setup.probe, model, model.cracks.broken_joints(), setup.model.head_datum);
  return {.model = std::move(model),
          .execution = Execution(Backend::host, omp_get_max_threads()),
          .probes = std::move(probes),
          .in_place_at_start = 0.0,
          .summary = {}};
}

class FlowTask : public Task {
public:
  FlowTask(const Setup& setup, const mesh::GmshMesh& mesh)
      : setup_(setup), run_(make_run(setup, mesh)), fracture_names_(fracture_table_names(setup)) {
    if (setup.initial.steady) {
      seepage::solve_steady(run_.model, run_.execution);
    }
    run_.in_place_at_start = seepage::fluid_in_place(run_.model, run_.execution);
    run_.summary.warnings = model_warnings(setup, run_.model);
    const std::vector<std::string>& left_out = run_.probes.warnings();
    run_.summary.warnings.insert(run_.summary.warnings.end(), left_out.begin(), left_out.end());
  }

  [[nodiscard]] CheckReport check() const override {
    return make_check_report(setup_, run_.model, run_.summary.warnings);
  }

  void begin(Observer& observer) override {
    for (const std::string& warning : run_.summary.warnings) {
      observer.on_warning(warning);
    }
    if (TransientRun* transient = choose_scheme()) {
      transient->begin(observer);
    }
  }

  void begin_from(StateArchive& state, Observer& observer) override {
    if (TransientRun* transient = choose_scheme()) {
      transient->begin_from(state, observer);
    }
  }

  Reached advance(Observer& observer, const std::function<bool()>& stop,
                  const Pause& pause) override {
    if (transient_) {
      return transient_->advance(observer, stop, pause);
    }
    if (run_.summary.steps == 0) {
      run_steady(setup_, run_, observer);
    }
    return Reached::end;
  }

  void leave(Observer& observer) override {
    if (transient_) {
      transient_->leave(observer);
    }
  }

  [[nodiscard]] Frame frame() const override {
    return {time(), steps(), matrix_frame(run_.model, setup_.model.head_datum),
            crack_frame(run_.model, setup_.model.head_datum)};
  }
  [[nodiscard]] std::vector<ProbeSample> probes() const override {
    return run_.probes.read(run_.model);
  }
  [[nodiscard]] HistoryRow look() override {
    if (setup_.time.scheme == Scheme::steady && run_.summary.steps > 0) {
      return run_.summary.last;
    }
    HistoryRow row =
        history_row(run_.model, mass_balance(run_.model, run_.in_place_at_start, run_.execution));
    row.step = run_.summary.steps;
    return row;
  }
  [[nodiscard]] double time() const override { return run_.model.state.time; }
  [[nodiscard]] std::int64_t steps() const override { return run_.summary.steps; }
  [[nodiscard]] FluidAccess fluid() override { return {&run_.model, &run_.in_place_at_start}; }
  [[nodiscard]] ConditionAccess conditions() override { return {&run_.model, {}}; }
  [[nodiscard]] const seepage::Model* flow() const override { return &run_.model; }
  [[nodiscard]] Summary summary() const override { return finished_summary(run_); }
  [[nodiscard]] const std::vector<std::string>& region_names() const override {
    return run_.model.mesh.region_names;
  }
  [[nodiscard]] const std::vector<std::string>& fracture_names() const override {
    return fracture_names_;
  }

private:
  /// Null in a steady run.
  TransientRun* choose_scheme() {
    switch (setup_.time.scheme) {
    case Scheme::steady:
      return nullptr;
    case Scheme::implicit:
      return &transient_.emplace(setup_, run_, implicit_scheme(setup_, run_));
    case Scheme::quasi_static:
    case Scheme::explicit_:
      break;
    }
    return &transient_.emplace(setup_, run_, explicit_scheme(setup_, run_));
  }

  Setup setup_;
  RunState run_;
  std::vector<std::string> fracture_names_;
  std::optional<TransientRun> transient_;  // once it has begun
};

}  // namespace

std::unique_ptr<Task> make_flow_task(const Setup& setup, const mesh::GmshMesh& mesh) {
  return std::make_unique<FlowTask>(setup, mesh);
}

}  // namespace percolith::simulation
