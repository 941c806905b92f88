// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/cli/commands.hpp"
#include "percolith/cli/console.hpp"
#include "percolith/cli/drive_run.hpp"
#include "percolith/core/error.hpp"
#include "percolith/io/run_directory.hpp"

#include <filesystem>
#include <system_error>

namespace percolith::cli {
namespace {

std::filesystem::path output_folder(const RunOptions& options) {
  if (options.output && options.output->empty()) {
    throw InputError({{}, "--output", "", "the name of the folder is empty", "a new folder"});
  }
  return options.output.value_or(io::RunDirectory::default_path(options.case_file));
}

/// Who names a folder of results wants to go on with it.
void require_no_folder(const std::filesystem::path& case_file) {
  std::error_code failure;
  if (std::filesystem::is_directory(case_file, failure)) {
    throw InputError({{},
                      case_file.string(),
                      "",
                      "is a folder; a run begins with a case file",
                      "a case file, or percolith run --resume FOLDER to go on with results"});
  }
}

}  // namespace

int run(const RunOptions& options) {
  require_no_folder(options.case_file);
  Interruption interruption;
  runner::RunRequest request;
  request.source = {options.case_file, {}, options.overrides};
  request.output = output_folder(options);
  request.existing = options.force ? io::Existing::replace : io::Existing::refuse;
  request.threads = options.threads;
  request.quiet = options.quiet;
  return drive_run(interruption, *runner::CaseRun::start(request, program_console()));
}

}  // namespace percolith::cli
