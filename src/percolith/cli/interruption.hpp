// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace percolith::cli {

/// Takes care of signals while a case runs, as long as this object lives. SIGINT and SIGTERM ask
/// the run to stop; before `begin`, and SIGINT the second time, they end the program at once with
/// the exit code 128 + signal. SIGPIPE and SIGXFSZ are ignored, so that a write to a closed pipe or
/// beyond the file size limit fails like any other write. One at a time.
class Interruption {
public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  /// From now on the first signal only asks.
  void begin();
  /// The signal that asks the run to stop, 0 while there is none.
  [[nodiscard]] int signal() const;
};

}  // namespace percolith::cli
