// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>

namespace percolith::bench {

/// Wall time since construction, s.
class Stopwatch {
public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Processor time of the whole process since construction, s. Other programs on the machine do not
/// add to it, so it is what ratios of long one-threaded computations are made of.
class ProcessorClock {
public:
  [[nodiscard]] double seconds() const { return now() - start_; }

private:
  static double now() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  }
  double start_ = now();
};

/// The smallest of several measurements: what the machine needs when nothing disturbs it.
class Best {
public:
  void add(double value) { value_ = std::min(value_, value); }
  [[nodiscard]] double value() const { return value_; }

private:
  double value_ = std::numeric_limits<double>::infinity();
};

}  // namespace percolith::bench
