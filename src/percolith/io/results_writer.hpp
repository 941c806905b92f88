// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/io/file_output.hpp"
#include "percolith/io/time_series.hpp"
#include "percolith/simulation/report.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace percolith::io {

/// Writes what a simulation reports into a run's folder: `history.csv`, `probes/<name>.csv`,
/// `matrix.pvd` and, from the first frame with an open crack on, `cracks.pvd`, with their files
/// under `fields/`; `events.csv` from the first call of on_events on, even where it tells of no
/// event, and `fragments.csv` likewise. Every call leaves complete lines and complete files; it
/// throws FileError where the system refuses.
class ResultsWriter : public simulation::Observer {
public:
  /// `folder` exists; `has_cracks`: the model has fractures.
  ResultsWriter(std::filesystem::path folder, bool has_cracks);
  void on_history(const simulation::HistoryRow& row) override;
  void on_frame(const simulation::Frame& frame) override;
  void on_probes(double time, const std::vector<simulation::ProbeSample>& samples) override;
  void on_events(const std::vector<simulation::BreakEvent>& events) override;
  void on_fragments(double time, const std::vector<simulation::FragmentRow>& rows) override;

private:
  std::filesystem::path folder_;
  bool has_cracks_;
  std::optional<AppendFile> history_;
  std::optional<AppendFile> events_;
  std::optional<AppendFile> fragments_;
  std::map<std::string, AppendFile> probes_;
  TimeSeries matrix_series_;
  TimeSeries crack_series_;
  int frames_ = 0;
};

}  // namespace percolith::io
