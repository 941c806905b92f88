// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/simulation.hpp"

#include "percolith/simulation/task.hpp"

namespace percolith::simulation {
namespace {

std::unique_ptr<Task> make_task(const Setup& setup, const mesh::GmshMesh& mesh) {
  switch (setup.model.physics) {
  case Physics::mechanics:
    return make_solid_task(setup, mesh);
  case Physics::coupled:
    return make_coupled_task(setup, mesh);
  case Physics::seepage:
    break;
  }
  return make_flow_task(setup, mesh);
}

}  // namespace

Simulation::Simulation(const Setup& setup, const mesh::GmshMesh& mesh)
    : task_(make_task(setup, mesh)) {}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

CheckReport Simulation::check() const {
  return task_->check();
}

bool Simulation::run(Observer& observer, const std::function<bool()>& stop) {
  return task_->run(observer, stop);
}

bool Simulation::resume(StateArchive& state, Observer& observer,
                        const std::function<bool()>& stop) {
  return task_->resume(state, observer, stop);
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
