// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/cli/checkpoint_keeper.hpp"
#include "percolith/cli/command_line.hpp"
#include "percolith/cli/load_model.hpp"
#include "percolith/cli/run_log.hpp"
#include "percolith/io/observers.hpp"
#include "percolith/io/progress_line.hpp"
#include "percolith/io/results_writer.hpp"
#include "percolith/io/run_directory.hpp"
#include "percolith/io/summary.hpp"

#include <string>

namespace percolith::cli {

/// Everything a run leaves behind: the resolved input at once, results, log and progress while it
/// goes, and how it ended. Writing throws FileError.
class RunRecorder {
public:
  /// A run that starts: leaves its resolved input at once. `directory` and `model` must outlive the
  /// recorder.
  RunRecorder(const io::RunDirectory& directory, const RunOptions& options,
              const LoadedModel& model);
  /// A run that goes on from a checkpoint of this origin; `read_state` must come next.
  RunRecorder(const io::RunDirectory& directory, const RunOptions& options,
              const LoadedModel& model, const io::CheckpointOrigin& origin);

  /// Reads how far the results had come; nothing is changed yet. Throws FileError where they are
  /// not there any more.
  void read_state(StateArchive& state) { state("results", results_); }

  /// Receives the reports of the simulation.
  [[nodiscard]] simulation::Observer& observer() { return observers_; }

  void finish();
  void interrupt(int signal);
  /// Leaves what can still be left (the disk may be full); throws nothing, because the error that
  /// ended the run is the one to tell.
  void fail(const std::string& reason) noexcept;

private:
  RunRecorder(const io::RunDirectory& directory, const RunOptions& options,
              const LoadedModel& model, const std::string& resolved);
  void write_summary(io::Outcome outcome, const std::string& reason);
  void say(const std::string& text);

  const io::RunDirectory& directory_;
  const LoadedModel& model_;
  double started_;  // s, wall time
  bool is_quiet_;
  bool has_begun_ = false;  // to change what the folder holds
  io::RunRecord record_;
  io::ResultsWriter results_;
  io::ProgressLine progress_;
  RunLog log_;
  CheckpointKeeper keeper_;
  io::Observers observers_;
};

}  // namespace percolith::cli
