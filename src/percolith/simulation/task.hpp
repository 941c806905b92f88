// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/gmsh_mesh.hpp"
#include "percolith/simulation/pause.hpp"
#include "percolith/simulation/report.hpp"
#include "percolith/simulation/setup.hpp"
#include "percolith/simulation/starting_motion.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace percolith::seepage {
struct Model;
}

namespace percolith::simulation {

/// Fluid that can be written to while a run waits.
struct FluidAccess {
  seepage::Model* model = nullptr;
  double* in_place_at_start = nullptr;  ///< m2
};

/// Conditions of the flow that can be changed while a run waits.
struct ConditionAccess {
  seepage::Model* model = nullptr;
  std::vector<std::string> pressing;  ///< names of those that press on the rock as well
};

/// What every kind of physics does for a `Simulation`, which says what is expected of each.
class Task {
public:
  Task() = default;
  Task(const Task&) = delete;
  Task& operator=(const Task&) = delete;
  virtual ~Task() = default;
  [[nodiscard]] virtual CheckReport check() const = 0;
  virtual void begin(Observer& observer) = 0;
  virtual void begin_from(StateArchive& state, Observer& observer) = 0;
  virtual Reached advance(Observer& observer, const std::function<bool()>& stop,
                          const Pause& pause) = 0;
  virtual void leave(Observer& observer) = 0;
  [[nodiscard]] virtual Frame frame() const = 0;
  [[nodiscard]] virtual std::vector<ProbeSample> probes() const = 0;
  [[nodiscard]] virtual HistoryRow look() = 0;
  [[nodiscard]] virtual double time() const = 0;
  [[nodiscard]] virtual std::int64_t steps() const = 0;
  /// What holds the fluid, null where there is none, and the fluid there was at time zero, m2.
  [[nodiscard]] virtual FluidAccess fluid() { return {}; }
  [[nodiscard]] virtual ConditionAccess conditions() { return {}; }
  [[nodiscard]] virtual const seepage::Model* flow() const { return nullptr; }
  [[nodiscard]] virtual const mechanics::Model* motion() const { return nullptr; }
  [[nodiscard]] virtual Summary summary() const = 0;
  [[nodiscard]] virtual const std::vector<std::string>& region_names() const = 0;
  [[nodiscard]] virtual const std::vector<std::string>& fracture_names() const = 0;
};

/// Flow through a rock at rest, motion of a dry rock, and both coupled. They throw InputError as
/// the constructor of `Simulation` does.
[[nodiscard]] std::unique_ptr<Task> make_flow_task(const Setup& setup, const mesh::GmshMesh& mesh);
[[nodiscard]] std::unique_ptr<Task> make_solid_task(const Setup& setup, const mesh::GmshMesh& mesh,
                                                    const StartingMotion& start);
[[nodiscard]] std::unique_ptr<Task> make_coupled_task(const Setup& setup,
                                                      const mesh::GmshMesh& mesh);

}  // namespace percolith::simulation
