// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/cli/commands.hpp"
#include "percolith/cli/console.hpp"
#include "percolith/cli/drive_run.hpp"
#include "percolith/core/error.hpp"

#include <fmt/format.h>

namespace percolith::cli {

int resume(const RunOptions& options) {
  Interruption interruption;
  const std::unique_ptr<runner::CaseRun> run =
      runner::CaseRun::reopen(*options.resume, options.threads, options.quiet, program_console());
  if (run) {
    return drive_run(interruption, *run);
  }
  if (!options.quiet) {
    print(fmt::format("the run in {} has finished; there is nothing to go on with\n",
                      options.resume->string()));
  }
  return static_cast<int>(ExitCode::success);
}

}  // namespace percolith::cli
