// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/cli/commands.hpp"
#include "percolith/cli/console.hpp"
#include "percolith/cli/interruption.hpp"
#include "percolith/cli/load_model.hpp"
#include "percolith/cli/run_recorder.hpp"
#include "percolith/core/error.hpp"
#include "percolith/io/run_directory.hpp"

#include <omp.h>

#include <exception>

namespace percolith::cli {

namespace {

std::filesystem::path output_folder(const RunOptions& options) {
  if (options.output && options.output->empty()) {
    throw InputError({{}, "--output", "", "the name of the folder is empty", "a new folder"});
  }
  return options.output.value_or(io::RunDirectory::default_path(options.case_file));
}

}  // namespace

int run(const RunOptions& options) {
  Interruption interruption;
  const auto path = output_folder(options);
  const io::Existing existing = options.force ? io::Existing::replace : io::Existing::refuse;
  io::RunDirectory::require_usable(path, existing);
  if (options.threads) {
    omp_set_num_threads(*options.threads);
  }
  LoadedModel model = load_model(options.case_file, options.overrides);

  const io::RunDirectory directory = io::RunDirectory::open(path, existing);
  interruption.begin();
  RunRecorder recorder(directory, options, model);
  bool finished = false;
  try {
    finished =
        model.simulation.run(recorder.observer(), [&] { return interruption.signal() != 0; });
  } catch (const std::exception& error) {
    recorder.fail(error.what());
    throw;
  }
  if (!finished) {
    recorder.interrupt(interruption.signal());
    return 128 + interruption.signal();
  }
  recorder.finish();
  return static_cast<int>(ExitCode::success);
}

}  // namespace percolith::cli
