// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/io/observers.hpp"
#include "percolith/io/progress_line.hpp"
#include "percolith/io/results_writer.hpp"
#include "percolith/io/run_directory.hpp"
#include "percolith/io/summary.hpp"
#include "percolith/runner/checkpoint_keeper.hpp"
#include "percolith/runner/console.hpp"
#include "percolith/runner/load_model.hpp"
#include "percolith/runner/run_log.hpp"

#include <string>

namespace percolith::runner {

/// How a run is told of while it goes.
struct RecorderOptions {
  bool quiet = false;  ///< no progress
  Console console;
};

/// Everything a run leaves behind: the resolved input at once, results, log and progress while it
/// goes, and how it ended. Writing throws FileError.
class RunRecorder {
public:
  /// A run that starts: leaves its resolved input at once. `directory` and `model` must outlive the
  /// recorder.
  RunRecorder(const io::RunDirectory& directory, const std::string& case_file,
              const LoadedModel& model, const RecorderOptions& options);
  /// A run that goes on from a checkpoint of this origin; `read_state` must come next.
  RunRecorder(const io::RunDirectory& directory, const io::CheckpointOrigin& origin,
              const LoadedModel& model, const RecorderOptions& options);

  /// Reads how far the results had come; nothing is changed yet. Throws FileError where they are
  /// not there any more.
  void read_state(StateArchive& state) { state("results", results_); }

  /// Receives the reports of the simulation.
  [[nodiscard]] simulation::Observer& observer() { return observers_; }

  /// A line of the log.
  void note(const std::string& text) { log_.information(text); }
  void finish();
  /// `by`: what stopped it, a signal for instance.
  void interrupt(const std::string& by);
  /// Leaves what can still be left (the disk may be full); throws nothing, because the error that
  /// ended the run is the one to tell.
  void fail(const std::string& reason) noexcept;

private:
  RunRecorder(const io::RunDirectory& directory, const std::string& case_file,
              const LoadedModel& model, const RecorderOptions& options,
              const std::string& resolved);
  void write_summary(io::Outcome outcome, const std::string& reason);
  void say(const std::string& text);

  const io::RunDirectory& directory_;
  const LoadedModel& model_;
  double started_;  // s, wall time
  RecorderOptions options_;
  bool has_begun_ = false;  // to change what the folder holds
  io::RunRecord record_;
  io::ResultsWriter results_;
  io::ProgressLine progress_;
  RunLog log_;
  CheckpointKeeper keeper_;
  io::Observers observers_;
};

}  // namespace percolith::runner
