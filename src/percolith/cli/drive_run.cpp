// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/cli/drive_run.hpp"

#include "percolith/core/error.hpp"

#include <exception>

namespace percolith::cli {

int drive_run(Interruption& interruption, RunRecorder& recorder,
              const std::function<bool(const std::function<bool()>& stop)>& work) {
  interruption.begin();
  bool finished = false;
  try {
    finished = work([&] { return interruption.signal() != 0; });
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
