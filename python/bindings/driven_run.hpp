// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/io/progress_line.hpp"
#include "percolith/runner/case_run.hpp"
#include "percolith/runner/text_tables.hpp"

#include <nanobind/nanobind.h>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace percolith::python {

/// How a run speaks to Python: `print(text)` for progress, `alert(line)` for warnings.
struct Voice {
  nanobind::object print, alert;
};

/// A run as Python drives it. Work is done without the interpreter's lock; one thread at a time.
class DrivenRun {
public:
  static std::unique_ptr<DrivenRun> start(const runner::RunRequest& request, const Voice& voice);
  /// Null where the run has finished.
  static std::unique_ptr<DrivenRun> reopen(const std::string& folder, std::optional<int> threads,
                                           bool quiet, const Voice& voice);

  /// Reports time zero, or takes up the checkpoint, unless that was done.
  void begin();
  /// Until `until` (s), or for `steps`, or to the next output; true where it can go on. A signal
  /// that raises an exception in Python ends the run with its results kept.
  bool advance(double until, std::int64_t steps, bool at_output);
  /// Ends a run that has not come to its end; `by` says what did it.
  void close(const std::string& by);

  [[nodiscard]] bool has_begun() const { return begun_; }
  [[nodiscard]] bool is_over() const { return over_; }
  /// Calls `work` on the simulation while nothing else does.
  template <class Work>
  auto with(const Work& work) {
    const Hold hold(busy_);
    return work(run_->simulation());
  }
  [[nodiscard]] const std::shared_ptr<runner::CaseRun>& run() const { return run_; }
  [[nodiscard]] int outputs() const { return tables_.outputs(); }
  [[nodiscard]] const std::map<std::string, std::string>& tables() const {
    return tables_.tables();
  }

private:
  /// Marks the run as busy, or throws where it is.
  class Hold {
  public:
    explicit Hold(std::atomic<bool>& busy);
    ~Hold() { busy_ = false; }
    Hold(const Hold&) = delete;
    Hold& operator=(const Hold&) = delete;

  private:
    std::atomic<bool>& busy_;
  };
  /// Passes warnings on where no log does.
  class Teller : public simulation::Observer {
  public:
    explicit Teller(runner::Console console) : console_(std::move(console)) {}
    void on_warning(const std::string& text) override { console_.alert("warning: " + text); }

  private:
    runner::Console console_;
  };

  DrivenRun(std::unique_ptr<runner::CaseRun> run, const runner::Console& console, bool keeps_log,
            bool quiet);
  void begin_unlocked();

  std::shared_ptr<runner::CaseRun> run_;
  runner::TextTables tables_;
  Teller teller_;
  io::ProgressLine progress_;
  bool begun_ = false;
  bool over_ = false;
  std::atomic<bool> busy_ = false;
};

}  // namespace percolith::python
