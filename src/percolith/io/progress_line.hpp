// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/report.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace percolith::io {

/// `seconds` for people: "4.2 s", "3 min 05 s", "2 h 10 min", "5 d 03 h".
[[nodiscard]] std::string format_duration(double seconds);

/// One line on where a run stands, what matters most first, since a narrow terminal cuts its end:
/// step, time, share of the end time, wall time `remaining` in s (left out when negative), broken
/// joints in mechanics, step size with what limits it, iterations of the last step.
[[nodiscard]] std::string format_progress(const simulation::Progress& progress, double remaining);

/// How progress is shown: one line redrawn in place, or a new line now and then.
enum class ProgressStyle { terminal, plain };

/// Shows progress: on a terminal at most five times a second, else a line every 10 s or for each
/// tenth of the end time.
class ProgressLine : public simulation::Observer {
public:
  using Print = std::function<void(std::string_view)>;  ///< shows the characters at once
  using Clock = std::function<double()>;                ///< wall time in s from any start

  /// `width`: columns of the terminal; a longer line is cut.
  ProgressLine(ProgressStyle style, int width, Print print, Clock clock);
  void on_progress(const simulation::Progress& progress) override;
  /// Removes the line from the terminal, so that other text can be printed.
  void clear();

private:
  [[nodiscard]] bool is_due(const simulation::Progress& progress, double now) const;
  [[nodiscard]] double remaining(const simulation::Progress& progress, double now);

  ProgressStyle style_;
  int width_;
  Print print_;
  Clock clock_;
  double last_shown_;        // s
  double last_share_ = 0.0;  // of the end time, at the last plain line
  bool is_drawn_ = false;
  // Pace of the steps, averaged over about the last ten shown lines.
  std::int64_t paced_step_ = -1;
  double paced_at_ = 0.0;
  double seconds_per_step_ = -1.0;
};

}  // namespace percolith::io
