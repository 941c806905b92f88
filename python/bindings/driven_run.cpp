// SPDX-License-Identifier: BSD-3-Clause
#include "driven_run.hpp"

#include <chrono>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "interrupts.hpp"

namespace nb = nanobind;

namespace percolith::python {
namespace {

using Shown = std::function<void(std::string_view)>;

/// A function of Python that can be called while its lock is not held, and forgotten likewise.
Shown callable(const nb::object& function) {
  const std::shared_ptr<nb::object> kept(new nb::object(function), [](nb::object* object) {
    const nb::gil_scoped_acquire lock;
    const std::unique_ptr<nb::object> ended(object);
  });
  return [kept](std::string_view text) {
    const nb::gil_scoped_acquire lock;
    (*kept)(nb::str(text.data(), text.size()));
  };
}

runner::Console console_of(const Voice& voice) {
  return {.print = callable(voice.print), .alert = callable(voice.alert), .is_python = true};
}

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

DrivenRun::Hold::Hold(std::atomic<bool>& busy) : busy_(busy) {
  if (busy_.exchange(true)) {
    throw std::runtime_error("the simulation is at work in another thread");
  }
}

DrivenRun::DrivenRun(std::unique_ptr<runner::CaseRun> run, const runner::Console& console,
                     bool keeps_log, bool quiet)
    : run_(std::move(run)), teller_(console),
      progress_(io::ProgressStyle::plain, console.width, console.print, seconds_now) {
  run_->add_observer(tables_);
  if (!keeps_log) {
    run_->add_observer(teller_);
    for (const std::string& warning : run_->read_case().warnings) {
      console.alert(warning);
    }
    if (!quiet) {
      run_->add_observer(progress_);
    }
  }
}

std::unique_ptr<DrivenRun> DrivenRun::start(const runner::RunRequest& request, const Voice& voice) {
  const runner::Console console = console_of(voice);
  const nb::gil_scoped_release unlocked;
  return std::unique_ptr<DrivenRun>(new DrivenRun(runner::CaseRun::start(request, console), console,
                                                  request.output.has_value(), request.quiet));
}

std::unique_ptr<DrivenRun> DrivenRun::reopen(const std::string& folder, std::optional<int> threads,
                                             bool quiet, const Voice& voice) {
  const runner::Console console = console_of(voice);
  const nb::gil_scoped_release unlocked;
  std::unique_ptr<runner::CaseRun> run = runner::CaseRun::reopen(folder, threads, quiet, console);
  return run ? std::unique_ptr<DrivenRun>(new DrivenRun(std::move(run), console, true, quiet))
             : nullptr;
}

void DrivenRun::begin_unlocked() {
  if (begun_) {
    return;
  }
  begun_ = true;
  try {
    run_->begin();
  } catch (...) {
    over_ = true;
    throw;
  }
}

void DrivenRun::begin() {
  const Hold hold(busy_);
  const nb::gil_scoped_release unlocked;
  begin_unlocked();
}

bool DrivenRun::advance(double until, std::int64_t steps, bool at_output) {
  if (over_) {
    return false;
  }
  const Hold hold(busy_);
  Interrupts interrupts;
  simulation::Reached reached = simulation::Reached::pause;
  {
    const nb::gil_scoped_release unlocked;
    try {
      begin_unlocked();
      reached = run_->advance([&] { return interrupts.should_stop(); }, {until, steps, at_output});
      if (reached == simulation::Reached::stop) {
        run_->interrupt(interrupts.signal_name());
      }
    } catch (...) {
      over_ = true;
      throw;
    }
  }
  over_ = reached != simulation::Reached::pause;
  if (interrupts.raised()) {
    throw nb::python_error(*interrupts.raised());
  }
  return !over_;
}

void DrivenRun::close(const std::string& by) {
  if (over_) {
    return;
  }
  const Hold hold(busy_);
  const nb::gil_scoped_release unlocked;
  begin_unlocked();
  over_ = true;
  run_->leave(by);
}

}  // namespace percolith::python
