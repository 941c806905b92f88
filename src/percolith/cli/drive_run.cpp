// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/cli/drive_run.hpp"

#include "percolith/core/error.hpp"

#include <csignal>

namespace percolith::cli {

int drive_run(Interruption& interruption, runner::CaseRun& run) {
  interruption.begin();
  run.begin();
  const auto reached = run.advance([&] { return interruption.signal() != 0; });
  if (reached == simulation::Reached::end) {
    return static_cast<int>(ExitCode::success);
  }
  run.interrupt(interruption.signal() == SIGINT ? "SIGINT" : "SIGTERM");
  return 128 + interruption.signal();
}

}  // namespace percolith::cli
