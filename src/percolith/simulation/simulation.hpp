// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/gmsh_mesh.hpp"
#include "percolith/simulation/pause.hpp"
#include "percolith/simulation/report.hpp"
#include "percolith/simulation/setup.hpp"
#include "percolith/simulation/starting_motion.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace percolith::seepage {
struct Model;
}

namespace percolith::simulation {

class Task;

/// Pressures (Pa) and those before, per corner slot or per vertex.
struct PressureChange {
  std::span<const double> pressure, former;
};

/// Pressures in place, Pa: of the pores per corner slot, of the cracks per vertex.
struct PressureMemory {
  std::span<double> pores, cracks;
};

/// A model that is ready to run: mesh, properties, conditions and state.
class Simulation {
public:
  /// Builds the model at time zero. Throws InputError, with the option path as key, for unknown
  /// group names, contradicting conditions, an unusable mesh or a missing pressure datum.
  /// Only a dry rock may have a `start`, key `model.physics` otherwise.
  Simulation(const Setup& setup, const mesh::GmshMesh& mesh, const StartingMotion& start = {});
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Counts, mesh quality, stability limits and warnings of the model as built.
  [[nodiscard]] CheckReport check() const;

  /// Starts at time zero and reports it to `observer`.
  void begin(Observer& observer);

  /// Goes on as `begin` does from the state that a run of the same case sent to `on_checkpoint`,
  /// and comes to the same bits. Throws FileError where the state does not belong to this model;
  /// then nothing has been reported.
  void begin_from(StateArchive& state, Observer& observer);

  /// Makes steps until the end, or `pause`, and reports to `observer`; after `begin`. Stops after
  /// the current step when `stop` returns true, with a last frame and history row. Throws
  /// SolverError when it cannot go on; what was reported before remains valid.
  Reached advance(Observer& observer, const std::function<bool()>& stop, const Pause& pause = {});

  /// Ends a run that waits before its end: reports to `observer` what one that stops reports.
  void leave(Observer& observer);

  /// `begin` and `advance` to the end in one; true when the end was reached.
  bool run(Observer& observer, const std::function<bool()>& stop);
  /// The same from a checkpoint.
  bool resume(StateArchive& state, Observer& observer, const std::function<bool()>& stop);

  /// The present state as a frame, as probe samples and as a row of the history. Looking leaves no
  /// trace in what the run reports.
  [[nodiscard]] Frame frame() const;
  [[nodiscard]] std::vector<ProbeSample> probes() const;
  [[nodiscard]] HistoryRow look();

  [[nodiscard]] double time() const;  ///< s
  [[nodiscard]] std::int64_t steps() const;
  /// The flow, null in mechanics of dry rock; the motion, null in a run of flow alone.
  [[nodiscard]] const seepage::Model* flow() const;
  [[nodiscard]] const mechanics::Model* motion() const;
  /// Gives pores or open crack nodes the pressures `pressure` (Pa): per corner, equal at the
  /// corners of a node; per vertex. The fluid this adds or takes is no matter of the balance of
  /// mass, which counts from what was in place. Throws InputError (key `pressure`) for a value that
  /// is not finite or below the cavitation pressure, and where the model takes none.
  void set_pore_pressure(std::span<const double> pressure);
  void set_crack_pressure(std::span<const double> pressure);
  /// The same for those nodes of both that have another pressure than before, or for none.
  void change_pressures(const PressureChange& pores, const PressureChange& cracks);
  /// Where these pressures stand. What is written there is half a change: put back what stood
  /// there and hand both to `change_pressures`. Throws as above where the model takes none.
  [[nodiscard]] PressureMemory pressure_memory();

  /// From now on the condition of the flow whose option is `path` (`source.well.rate`) has this
  /// value (SI) at all times. Throws InputError (key `path`) for another path, a value that is not
  /// finite or a pressure below the cavitation pressure, and where the condition presses on the
  /// rock as well.
  void set_condition(const std::string& path, double value);

  [[nodiscard]] Summary summary() const;
  /// Names that `MatrixFrame::region` and `CrackFrame::group` index.
  [[nodiscard]] const std::vector<std::string>& region_names() const;
  [[nodiscard]] const std::vector<std::string>& fracture_names() const;

private:
  std::unique_ptr<Task> task_;
};

}  // namespace percolith::simulation
