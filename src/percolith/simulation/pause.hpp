// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>

namespace percolith::simulation {

/// Where a run that is advanced in parts waits: after the first step that reaches one of these.
/// No step is changed by it, so a run in parts comes to the bits of a run in one.
struct Pause {
  double time = std::numeric_limits<double>::infinity();          ///< s
  std::int64_t steps = std::numeric_limits<std::int64_t>::max();  ///< made in this part
  bool at_output = false;                                         ///< after the next output
};

/// Why an advance came back.
enum class Reached {
  pause,  ///< it can be advanced further
  stop,   ///< it was asked to stop, and has reported where it stands
  end     ///< nothing is left to do
};

/// Tells within one advance whether its pause is reached.
class PauseClock {
public:
  /// For an advance that starts before step number `step`.
  PauseClock(const Pause& pause, std::int64_t step) : pause_(pause), first_(step) {}
  /// After a step to the time `t` (s) that was the `step`-th; `output`: it was one of output.
  [[nodiscard]] bool over(double t, std::int64_t step, bool output) const {
    const bool moved = step > first_;
    return t >= pause_.time || step - first_ >= pause_.steps ||
           (moved && output && pause_.at_output);
  }

private:
  Pause pause_;
  std::int64_t first_;
};

}  // namespace percolith::simulation
