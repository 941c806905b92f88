// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/cli/commands.hpp"
#include "percolith/cli/drive_run.hpp"
#include "percolith/cli/load_model.hpp"
#include "percolith/cli/run_recorder.hpp"
#include "percolith/core/error.hpp"
#include "percolith/io/run_directory.hpp"

#include <omp.h>

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
  RunRecorder recorder(directory, options, model);
  return drive_run(interruption, recorder, [&](const std::function<bool()>& stop) {
    return model.simulation.run(recorder.observer(), stop);
  });
}

}  // namespace percolith::cli
