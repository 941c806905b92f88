// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/gmsh_mesh.hpp"
#include "percolith/simulation/report.hpp"
#include "percolith/simulation/setup.hpp"

#include <functional>
#include <memory>

namespace percolith::simulation {

/// What every kind of physics does for a `Simulation`, which says what is expected of each.
class Task {
public:
  Task() = default;
  Task(const Task&) = delete;
  Task& operator=(const Task&) = delete;
  virtual ~Task() = default;
  [[nodiscard]] virtual CheckReport check() const = 0;
  virtual bool run(Observer& observer, const std::function<bool()>& stop) = 0;
  virtual bool resume(StateArchive& state, Observer& observer,
                      const std::function<bool()>& stop) = 0;
  [[nodiscard]] virtual Summary summary() const = 0;
  [[nodiscard]] virtual const std::vector<std::string>& region_names() const = 0;
  [[nodiscard]] virtual const std::vector<std::string>& fracture_names() const = 0;
};

/// Flow through a rock at rest, motion of a dry rock, and both coupled. They throw InputError as
/// the constructor of `Simulation` does.
[[nodiscard]] std::unique_ptr<Task> make_flow_task(const Setup& setup, const mesh::GmshMesh& mesh);
[[nodiscard]] std::unique_ptr<Task> make_solid_task(const Setup& setup, const mesh::GmshMesh& mesh);
[[nodiscard]] std::unique_ptr<Task> make_coupled_task(const Setup& setup,
                                                      const mesh::GmshMesh& mesh);

}  // namespace percolith::simulation
