// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/cli/checkpoint_keeper.hpp"
#include "percolith/cli/commands.hpp"
#include "percolith/cli/console.hpp"
#include "percolith/cli/drive_run.hpp"
#include "percolith/cli/run_recorder.hpp"
#include "percolith/core/error.hpp"
#include "percolith/io/checkpoint_file.hpp"
#include "percolith/io/run_directory.hpp"
#include "percolith/io/summary.hpp"

#include <fmt/format.h>
#include <omp.h>

namespace percolith::cli {
namespace {

io::CheckpointFile last_checkpoint(const io::RunDirectory& directory) {
  const std::filesystem::path file = directory.file(io::checkpoint_name);
  if (!std::filesystem::exists(file)) {
    throw InputError({{},
                      "--resume",
                      directory.path().string(),
                      fmt::format("the folder holds no {}: the run was ended before its first "
                                  "checkpoint, or is a steady one",
                                  io::checkpoint_name),
                      "a run that left a checkpoint; see output.checkpoint_interval"});
  }
  return io::CheckpointFile(file);
}

}  // namespace

int resume(const RunOptions& options) {
  Interruption interruption;
  const io::RunDirectory directory = io::RunDirectory::reopen(*options.resume);
  if (io::has_finished(directory.path())) {
    // It may have been killed in between.
    directory.remove_checkpoint();
    if (!options.quiet) {
      print(fmt::format("the run in {} has finished; there is nothing to go on with\n",
                        directory.path().string()));
    }
    return static_cast<int>(ExitCode::success);
  }
  const io::CheckpointFile checkpoint = last_checkpoint(directory);
  if (options.threads) {
    omp_set_num_threads(*options.threads);
  }
  const std::filesystem::path case_file = directory.file("resolved.toml");
  const std::string resolved = io::read_file(case_file);
  // Before the model is built, which may fail for what the next line tells better.
  io::CheckpointOrigin origin =
      checkpoint_origin(resolved, checkpoint.origin().mesh_hash, checkpoint.origin().case_file);
  checkpoint.require_origin(origin);
  LoadedModel model = load_model(case_file, {});
  origin.mesh_hash = model.mesh_hash;
  checkpoint.require_origin(origin);

  StateReader state = checkpoint.state();
  RunRecorder recorder(directory, options, model, origin);
  recorder.read_state(state);
  return drive_run(interruption, recorder, [&](const std::function<bool()>& stop) {
    return model.simulation.resume(state, recorder.observer(), stop);
  });
}

}  // namespace percolith::cli
