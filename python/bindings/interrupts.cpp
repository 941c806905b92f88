// SPDX-License-Identifier: BSD-3-Clause
#include "interrupts.hpp"

#include <nanobind/stl/string.h>

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

std::string Interrupts::signal_name() const {
  const nb::gil_scoped_acquire lock;
  if (raised_ && nb::hasattr(raised_->value(), "signal_name")) {
    return nb::cast<std::string>(raised_->value().attr("signal_name"));
  }
  return "SIGINT";
}

}  // namespace percolith::python
