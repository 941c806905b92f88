// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/seepage/implicit_flow.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace percolith::test {

/// Advances by steps of `dt`; a step without a solution is cut in four. Returns the attempts.
inline int advance_implicit(seepage::ImplicitFlow& flow, seepage::Model& model, double end,
                            double dt) {
  Execution execution;
  int attempts = 0;
  double step = dt;
  while (model.state.time < end * (1.0 - 1e-12)) {
    const double rest = end - model.state.time;
    const double now = std::min(step, rest);
    ++attempts;
    if (attempts > 100'000 || now < 1e-14 * end) {
      ADD_FAILURE() << "no solution at time " << model.state.time << " with step " << now;
      return attempts;
    }
    if (flow.attempt(model, now, execution)) {
      flow.accept(model);
      step = std::min(2.0 * step, dt);
    } else {
      step = 0.25 * now;
    }
  }
  return attempts;
}

}  // namespace percolith::test
