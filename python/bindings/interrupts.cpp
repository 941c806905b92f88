// SPDX-License-Identifier: BSD-3-Clause
#include "interrupts.hpp"

namespace nb = nanobind;

namespace percolith::python {

bool Interrupts::should_stop() {
  if (raised_) {
    return true;
  }
  const auto now = Clock::now();
  if (now < next_) {
    return false;
  }
  next_ = now + interval;
  const nb::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() != 0) {
    raised_.emplace();
  }
  return raised_.has_value();
}

}  // namespace percolith::python
