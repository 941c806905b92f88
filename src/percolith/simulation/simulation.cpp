// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/simulation.hpp"

#include "percolith/seepage/steady_flow.hpp"
#include "percolith/simulation/build_model.hpp"
#include "percolith/simulation/check_report.hpp"
#include "percolith/simulation/event_clock.hpp"
#include "percolith/simulation/run.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <utility>

namespace percolith::simulation {

/// Everything a run works on.
struct Simulation::Model {
  Setup setup;
  RunState run;
  std::vector<std::string> fracture_names;
};

Simulation::Simulation(const Setup& setup, const mesh::GmshMesh& mesh) {
  require_sensible_intervals(setup);
  seepage::Model model = build_model(setup, mesh);
  require_datum(setup, model);
  ProbeReader probes(setup.probe, model, setup.model.head_datum);
  model_ = std::make_unique<Model>(
      Model{setup,
            RunState{.model = std::move(model),
                     .execution = Execution(Backend::host, omp_get_max_threads()),
                     .probes = std::move(probes),
                     .in_place_at_start = 0.0,
                     .summary = {}},
            fracture_table_names(setup)});
  if (setup.initial.steady) {
    seepage::solve_steady(model_->run.model, model_->run.execution);
  }
  model_->run.in_place_at_start = seepage::fluid_in_place(model_->run.model, model_->run.execution);
  model_->run.summary.warnings = model_warnings(setup, model_->run.model);
  const std::vector<std::string>& left_out = model_->run.probes.warnings();
  model_->run.summary.warnings.insert(model_->run.summary.warnings.end(), left_out.begin(),
                                      left_out.end());
}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

CheckReport Simulation::check() const {
  return make_check_report(model_->setup, model_->run.model, model_->run.summary.warnings);
}

bool Simulation::run(Observer& observer, const std::function<bool()>& stop) {
  for (const std::string& warning : model_->run.summary.warnings) {
    observer.on_warning(warning);
  }
  switch (model_->setup.time.scheme) {
  case Scheme::steady:
    run_steady(model_->setup, model_->run, observer);
    break;
  case Scheme::implicit:
    run_implicit(model_->setup, model_->run, observer, stop);
    break;
  case Scheme::explicit_:
    run_explicit(model_->setup, model_->run, observer, stop);
    break;
  }
  return model_->setup.time.scheme == Scheme::steady ||
         model_->run.model.state.time >= model_->setup.time.end;
}

Summary Simulation::summary() const {
  return finished_summary(model_->run);
}

const std::vector<std::string>& Simulation::region_names() const {
  return model_->run.model.mesh.region_names;
}

const std::vector<std::string>& Simulation::fracture_names() const {
  return model_->fracture_names;
}

}  // namespace percolith::simulation
