// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/cli/interruption.hpp"
#include "percolith/cli/run_recorder.hpp"

#include <functional>

namespace percolith::cli {

/// Runs `work`, which returns true where it came to its end and stops when the function it is given
/// returns true, records how it ended and returns the exit code of the program. What `work` throws
/// passes through once it is recorded.
[[nodiscard]] int drive_run(Interruption& interruption, RunRecorder& recorder,
                            const std::function<bool(const std::function<bool()>& stop)>& work);

}  // namespace percolith::cli
