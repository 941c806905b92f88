// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/steady_flow.hpp"
#include "percolith/simulation/build_model.hpp"
#include "percolith/simulation/check_report.hpp"
#include "percolith/simulation/event_clock.hpp"
#include "percolith/simulation/run.hpp"
#include "percolith/simulation/task.hpp"

#include <omp.h>

#include <utility>

namespace percolith::simulation {
namespace {

/// A model without state to run, and what it needs to run.
RunState make_run(const Setup& setup, const mesh::GmshMesh& mesh) {
  require_sensible_intervals(setup);
  seepage::Model model = build_model(setup, mesh);
  require_datum(setup, model);
  ProbeReader probes(setup.probe, model, setup.model.head_datum);
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

  bool run(Observer& observer, const std::function<bool()>& stop) override {
    for (const std::string& warning : run_.summary.warnings) {
      observer.on_warning(warning);
    }
    return advance(nullptr, observer, stop);
  }

  bool resume(StateArchive& state, Observer& observer, const std::function<bool()>& stop) override {
    return advance(&state, observer, stop);
  }

  [[nodiscard]] Summary summary() const override { return finished_summary(run_); }
  [[nodiscard]] const std::vector<std::string>& region_names() const override {
    return run_.model.mesh.region_names;
  }
  [[nodiscard]] const std::vector<std::string>& fracture_names() const override {
    return fracture_names_;
  }

private:
  bool advance(StateArchive* from, Observer& observer, const std::function<bool()>& stop) {
    switch (setup_.time.scheme) {
    case Scheme::steady:
      run_steady(setup_, run_, observer);
      break;
    case Scheme::implicit:
      run_implicit(setup_, run_, observer, stop, from);
      break;
    case Scheme::quasi_static:
    case Scheme::explicit_:
      run_explicit(setup_, run_, observer, stop, from);
      break;
    }
    return setup_.time.scheme == Scheme::steady || run_.model.state.time >= setup_.time.end;
  }

  Setup setup_;
  RunState run_;
  std::vector<std::string> fracture_names_;
};

}  // namespace

std::unique_ptr<Task> make_flow_task(const Setup& setup, const mesh::GmshMesh& mesh) {
  return std::make_unique<FlowTask>(setup, mesh);
}

}  // namespace percolith::simulation
