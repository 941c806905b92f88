// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/archive.hpp"

#include <limits>

namespace percolith {

/// Chooses time steps from the local error of a first-order scheme: the error of a step grows with
/// its square. Steps grow by doubling only, so that a factorised matrix serves many of them.
class StepControl {
public:
  /// `tolerance` is the error a step may have; `first` and `largest` are steps in s. Steps not
  /// above `smallest` resolve all there is and are good whatever their error, which may be relative
  /// to a quantity that grows with the step.
  StepControl(double tolerance, double first, double largest, double smallest = 0.0)
      : tolerance_(tolerance), step_(first < largest ? first : largest), largest_(largest),
        smallest_(smallest) {}

  /// The step to try next, s.
  [[nodiscard]] double step() const { return step_; }
  /// Takes the error of a finished attempt with step `dt`; true when the step is good. Otherwise
  /// the next step to try is smaller.
  [[nodiscard]] bool judge(double dt, double error);
  /// The attempt with step `dt` found no solution: quarter it.
  void failed(double dt) { step_ = 0.25 * dt; }
  void describe_state(StateArchive& archive) { archive("step", step_); }

private:
  double tolerance_;
  double step_;
  double largest_;
  double smallest_;
};

/// Splits the way to an event so that no step is a sliver: the step itself when the event is far,
/// half the rest when two steps reach it, the rest when one does.
[[nodiscard]] double step_towards(double time, double event, double step);

}  // namespace percolith
