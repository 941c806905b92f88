// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/archive.hpp"
#include "percolith/coupling/coupled_model.hpp"
#include "percolith/coupling/doing.hpp"

#include <functional>

namespace percolith::coupling {

/// How rock and fluid are advanced together.
class Scheme {
public:
  Scheme() = default;
  Scheme(const Scheme&) = delete;
  Scheme& operator=(const Scheme&) = delete;
  virtual ~Scheme() = default;

  /// One step of `dt` seconds; the time of both halves is that at its end. Throws SolverError where
  /// no solution is found.
  virtual mechanics::Changes advance(double dt, Execution& execution) = 0;
  /// A scheme whose steps take long asks `stop` on the way and gives the step up where it says so.
  virtual void listen(const std::function<bool()>& /*stop*/) {}
  /// To be asked from `stop`.
  [[nodiscard]] virtual Doing doing() const { return {}; }
  /// Whether the last step was given up: everything is as it was before it.
  [[nodiscard]] virtual bool gave_up() const { return false; }
  /// To be called when conditions have been added since the last step.
  virtual void network_changed() = 0;
  /// What the next step takes over from those before, beside the model; to be read once the model
  /// is.
  virtual void describe_state(StateArchive& archive) = 0;

  /// Fluid that has leaked out of the cracks into the rock since time zero, m2.
  [[nodiscard]] virtual double leaked() const = 0;
  /// Iterations of the last step.
  [[nodiscard]] virtual int iterations() const = 0;
  /// Parts the last step had to be cut in.
  [[nodiscard]] virtual int parts() const { return 1; }
};

}  // namespace percolith::coupling
