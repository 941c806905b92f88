// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/gmsh_mesh.hpp"
#include "percolith/simulation/report.hpp"
#include "percolith/simulation/setup.hpp"

#include <functional>
#include <memory>

namespace percolith::simulation {

class Task;

/// A model that is ready to run: mesh, properties, conditions and state.
class Simulation {
public:
  /// Builds the model at time zero. Throws InputError, with the option path as key, for unknown
  /// group names, contradicting conditions, an unusable mesh or a missing pressure datum.
  Simulation(const Setup& setup, const mesh::GmshMesh& mesh);
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Counts, mesh quality, stability limits and warnings of the model as built.
  [[nodiscard]] CheckReport check() const;

  /// Runs to the end and reports to `observer`; true when the end was reached. Stops after the
  /// current step when `stop` returns true, with a last frame and history row. Throws SolverError
  /// when it cannot go on; what was reported before remains valid.
  bool run(Observer& observer, const std::function<bool()>& stop);

  /// Goes on as `run` does from the state that a run of the same case sent to `on_checkpoint`, and
  /// comes to the same bits. Throws FileError where the state does not belong to this model; then
  /// nothing has been reported.
  bool resume(StateArchive& state, Observer& observer, const std::function<bool()>& stop);

  [[nodiscard]] Summary summary() const;
  /// Names that `MatrixFrame::region` and `CrackFrame::group` index.
  [[nodiscard]] const std::vector<std::string>& region_names() const;
  [[nodiscard]] const std::vector<std::string>& fracture_names() const;

private:
  std::unique_ptr<Task> task_;
};

}  // namespace percolith::simulation
