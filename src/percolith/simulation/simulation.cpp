// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/simulation.hpp"

#include "percolith/core/error.hpp"
#include "percolith/simulation/set_condition.hpp"
#include "percolith/simulation/set_pressure.hpp"
#include "percolith/simulation/task.hpp"

namespace percolith::simulation {
namespace {

std::unique_ptr<Task> make_task(const Setup& setup, const mesh::GmshMesh& mesh,
                                const StartingMotion& start) {
  if (!start.empty() && setup.model.physics != Physics::mechanics) {
    throw InputError({{},
                      "model.physics",
                      "",
                      "displacements and velocities are given to a rock with flow",
                      "those of a rock with \"mechanics\" alone"});
  }
  switch (setup.model.physics) {
  case Physics::mechanics:
    return make_solid_task(setup, mesh, start);
  case Physics::coupled:
    return make_coupled_task(setup, mesh);
  case Physics::seepage:
    break;
  }
  return make_flow_task(setup, mesh);
}

}  // namespace

Simulation::Simulation(const Setup& setup, const mesh::GmshMesh& mesh, const StartingMotion& start)
    : task_(make_task(setup, mesh, start)) {}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

CheckReport Simulation::check() const {
  return task_->check();
}

void Simulation::begin(Observer& observer) {
  task_->begin(observer);
}

void Simulation::begin_from(StateArchive& state, Observer& observer) {
  task_->begin_from(state, observer);
}

Reached Simulation::advance(Observer& observer, const std::function<bool()>& stop,
                            const Pause& pause) {
  return task_->advance(observer, stop, pause);
}

void Simulation::leave(Observer& observer) {
  task_->leave(observer);
}

bool Simulation::run(Observer& observer, const std::function<bool()>& stop) {
  begin(observer);
  return advance(observer, stop) == Reached::end;
}

bool Simulation::resume(StateArchive& state, Observer& observer,
                        const std::function<bool()>& stop) {
  begin_from(state, observer);
  return advance(observer, stop) == Reached::end;
}

Frame Simulation::frame() const {
  return task_->frame();
}

std::vector<ProbeSample> Simulation::probes() const {
  return task_->probes();
}

HistoryRow Simulation::look() {
  return task_->look();
}

double Simulation::time() const {
  return task_->time();
}

std::int64_t Simulation::steps() const {
  return task_->steps();
}

const seepage::Model* Simulation::flow() const {
  return task_->flow();
}

const mechanics::Model* Simulation::motion() const {
  return task_->motion();
}

void Simulation::set_pore_pressure(std::span<const double> pressure) {
  simulation::set_pore_pressure(task_->fluid(), pressure);
}

void Simulation::set_crack_pressure(std::span<const double> pressure) {
  simulation::set_crack_pressure(task_->fluid(), pressure);
}

void Simulation::change_pressures(const PressureChange& pores, const PressureChange& cracks) {
  simulation::change_pressures(task_->fluid(), pores, cracks);
}

PressureMemory Simulation::pressure_memory() {
  return simulation::pressure_memory(task_->fluid());
}

void Simulation::set_condition(const std::string& path, double value) {
  simulation::set_condition(task_->conditions(), path, value);
}

Summary Simulation::summary() const {
  return task_->summary();
}

const std::vector<std::string>& Simulation::region_names() const {
  return task_->region_names();
}

const std::vector<std::string>& Simulation::fracture_names() const {
  return task_->fracture_names();
}

}  // namespace percolith::simulation
