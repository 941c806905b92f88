// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/cli/interruption.hpp"
#include "percolith/runner/case_run.hpp"

namespace percolith::cli {

/// Takes a run to its end, or to where a signal stops it, and returns the exit code of the program.
/// What the run throws passes through.
[[nodiscard]] int drive_run(Interruption& interruption, runner::CaseRun& run);

}  // namespace percolith::cli
