// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/io/checkpoint_file.hpp"
#include "percolith/io/observers.hpp"
#include "percolith/io/run_directory.hpp"
#include "percolith/runner/console.hpp"
#include "percolith/runner/load_model.hpp"
#include "percolith/runner/run_recorder.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace percolith::runner {

/// What a new run is to be.
struct RunRequest {
  CaseSource source;
  std::optional<std::filesystem::path> output;  ///< absent: nothing is written
  io::Existing existing = io::Existing::refuse;
  std::optional<int> threads;  ///< absent: as many as OpenMP takes
  bool quiet = false;          ///< no progress
};

/// A case on its way to its results: the command line and the Python package both drive this, so
/// that they come to the same files bit for bit.
class CaseRun {
public:
  /// Reads the case, builds its model and takes over the folder for its results; earlier ones are
  /// replaced only once the model is there. Throws InputErrors with the place of the mistake, and
  /// FileErrors.
  [[nodiscard]] static std::unique_ptr<CaseRun> start(const RunRequest& request, Console console);

  /// The run in `folder`, to go on from its last checkpoint; null where it has finished. Nothing
  /// is changed before the checkpoint was read and found to belong to the case, the mesh and this
  /// program; throws InputErrors and FileErrors.
  [[nodiscard]] static std::unique_ptr<CaseRun> reopen(const std::filesystem::path& folder,
                                                       std::optional<int> threads, bool quiet,
                                                       Console console);

  /// From now on `observer` is told what the run reports, too; before `begin`.
  void add_observer(simulation::Observer& observer) { observers_.push_back(&observer); }

  /// Builds the model anew with this motion at time zero; before `begin`. What was seen of the
  /// model before stays as it was. Throws InputError as the constructor of `Simulation`, and where
  /// results are written, because a checkpoint would not tell of such a start.
  void start_from(const simulation::StartingMotion& start);

  /// As `Simulation::set_condition`, noted in the log.
  void set_condition(const std::string& path, double value);

  /// Starts, at time zero or from the checkpoint.
  void begin();
  /// As `Simulation::advance`. At the end the results are completed. What is thrown on the way is
  /// noted in the results first.
  simulation::Reached advance(const std::function<bool()>& stop,
                              const simulation::Pause& pause = {});
  /// Completes the results of a run that `advance` has stopped; `by`: what stopped it.
  void interrupt(const std::string& by);
  /// Ends a run that waits: it leaves a checkpoint, a last frame and row, and is interrupted.
  void leave(const std::string& by);

  [[nodiscard]] simulation::Simulation& simulation() { return model_.simulation; }
  [[nodiscard]] const case_file::Case& read_case() const { return model_.read_case; }

private:
  CaseRun(CaseSource source, LoadedModel model, std::optional<io::RunDirectory> directory)
      : source_(std::move(source)), directory_(std::move(directory)), model_(std::move(model)) {}
  template <class Work>
  auto guarded(const Work& work);
  /// Gives the folder free once nothing more is written to it.
  void release();

  CaseSource source_;
  std::optional<io::RunDirectory> directory_;
  LoadedModel model_;
  std::vector<simulation::Simulation> former_;  // that someone may still look at
  std::optional<RunRecorder> recorder_;
  std::unique_ptr<io::CheckpointFile> checkpoint_;  // what the run goes on from
  std::optional<StateReader> state_;                // of the checkpoint
  std::vector<simulation::Observer*> observers_;
  std::unique_ptr<io::Observers> observer_;
};

}  // namespace percolith::runner
