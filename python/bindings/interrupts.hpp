// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nanobind/nanobind.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string>

namespace percolith::python {

/// Lets Python look after its signals while C++ works without the interpreter's lock: Ctrl-C stops
/// the work after its present step.
class Interrupts {
public:
  /// True once a signal handler of Python has raised an exception; asks a few times a second.
  bool should_stop();
  /// The exception, once `should_stop` is true.
  [[nodiscard]] const std::optional<nanobind::python_error>& raised() const { return raised_; }
  /// Of the signal that was answered by the exception: its attribute `signal_name` where it has
  /// one, otherwise SIGINT.
  [[nodiscard]] std::string signal_name() const;

private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds interval{20};
  Clock::time_point next_ = Clock::now() + interval;
  std::optional<nanobind::python_error> raised_;
};

}  // namespace percolith::python
