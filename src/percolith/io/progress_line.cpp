// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/progress_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace percolith::io {
namespace {

constexpr double terminal_period = 0.2;  // s
constexpr double plain_period = 10.0;    // s
constexpr double plain_share = 0.1;      // of the end time

double share_done(const simulation::Progress& progress) {
  return progress.end > 0 ? std::min(progress.time / progress.end, 1.0) : 0.0;
}

}  // namespace

std::string format_duration(double seconds) {
  if (!(seconds < 3600.0 * 24 * 10000)) {
    return "very long";
  }
  if (seconds < 59.95) {
    return fmt::format("{:.1f} s", seconds);
  }
  const auto whole = std::llround(seconds);
  if (whole < 3600) {
    return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  }
  if (whole < 24 * 3600) {
    return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
  }
  return fmt::format("{} d {:02} h", whole / 86400, whole % 86400 / 3600);
}

std::string format_progress(const simulation::Progress& progress, double remaining) {
  std::string text = fmt::format("step {}", progress.step);
  if (progress.end > 0) {
    text += fmt::format("  time {:.4g} s of {:.4g} s ({:.0f} %)", progress.time, progress.end,
                        std::floor(100 * share_done(progress)));
  }
  if (remaining >= 0) {
    text += "  ETA " + format_duration(remaining);
  }
  if (progress.broken_joints) {
    text += fmt::format("  cracks {}", *progress.broken_joints);
  }
  if (progress.step_size > 0) {
    text += fmt::format("  step size {:.3g} s", progress.step_size);
    if (progress.limited_by != nullptr && *progress.limited_by != '\0') {
      text += fmt::format(" ({})", progress.limited_by);
    }
  }
  if (progress.iterations > 0) {
    text += fmt::format("  iterations {}", progress.iterations);
  }
  return text;
}

ProgressLine::ProgressLine(ProgressStyle style, int width, Print print, Clock clock)
    : style_(style), width_(width), print_(std::move(print)), clock_(std::move(clock)),
      last_shown_(style == ProgressStyle::terminal ? -terminal_period : clock_()) {}

bool ProgressLine::is_due(const simulation::Progress& progress, double now) const {
  if (style_ == ProgressStyle::terminal) {
    return now - last_shown_ >= terminal_period;
  }
  return now - last_shown_ >= plain_period ||
         std::floor(share_done(progress) / plain_share + 1e-9) >
             std::floor(last_share_ / plain_share + 1e-9);
}

// Implicit steps grow by orders of magnitude, so the share of the end time already done says
// nothing about the rest; the number of steps left at the present size does.
double ProgressLine::remaining(const simulation::Progress& progress, double now) {
  if (paced_step_ >= 0 && progress.step > paced_step_) {
    const double pace = (now - paced_at_) / static_cast<double>(progress.step - paced_step_);
    seconds_per_step_ = seconds_per_step_ < 0 ? pace : 0.9 * seconds_per_step_ + 0.1 * pace;
  }
  paced_step_ = progress.step;
  paced_at_ = now;
  if (seconds_per_step_ < 0 || progress.step_size <= 0 || progress.end <= 0) {
    return -1.0;
  }
  return std::max(progress.end - progress.time, 0.0) / progress.step_size * seconds_per_step_;
}

void ProgressLine::on_progress(const simulation::Progress& progress) {
  const double now = clock_();
  if (!is_due(progress, now)) {
    return;
  }
  last_shown_ = now;
  last_share_ = share_done(progress);
  std::string text = format_progress(progress, remaining(progress, now));
  if (style_ == ProgressStyle::plain) {
    print_(text + '\n');
    return;
  }
  if (width_ > 1 && text.size() >= static_cast<std::size_t>(width_)) {
    text.resize(static_cast<std::size_t>(width_) - 1);
  }
  print_("\r" + text + "\x1b[K");
  is_drawn_ = true;
}

void ProgressLine::clear() {
  if (is_drawn_) {
    print_("\r\x1b[K");
    is_drawn_ = false;
  }
}

}  // namespace percolith::io
