// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/report.hpp"

#include <utility>
#include <vector>

namespace percolith::io {

/// Hands every report on to several observers, in their order; they must outlive it.
class Observers : public simulation::Observer {
public:
  explicit Observers(std::vector<simulation::Observer*> observers)
      : observers_(std::move(observers)) {}
  void on_progress(const simulation::Progress& progress) override {
    for (Observer* observer : observers_) {
      observer->on_progress(progress);
    }
  }
  void on_history(const simulation::HistoryRow& row) override {
    for (Observer* observer : observers_) {
      observer->on_history(row);
    }
  }
  void on_frame(const simulation::Frame& frame) override {
    for (Observer* observer : observers_) {
      observer->on_frame(frame);
    }
  }
  void on_probes(double time, const std::vector<simulation::ProbeSample>& samples) override {
    for (Observer* observer : observers_) {
      observer->on_probes(time, samples);
    }
  }
  void on_events(const std::vector<simulation::BreakEvent>& events) override {
    for (Observer* observer : observers_) {
      observer->on_events(events);
    }
  }
  void on_fragments(double time, const std::vector<simulation::FragmentRow>& rows) override {
    for (Observer* observer : observers_) {
      observer->on_fragments(time, rows);
    }
  }
  void on_warning(const std::string& warning) override {
    for (Observer* observer : observers_) {
      observer->on_warning(warning);
    }
  }
  void on_checkpoint(const simulation::Checkpoint& checkpoint) override {
    for (Observer* observer : observers_) {
      observer->on_checkpoint(checkpoint);
    }
  }
  void on_resume(double time, std::int64_t step) override {
    for (Observer* observer : observers_) {
      observer->on_resume(time, step);
    }
  }

private:
  std::vector<simulation::Observer*> observers_;
};

}  // namespace percolith::io
