// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/archive.hpp"
#include "percolith/io/file_output.hpp"
#include "percolith/io/time_series.hpp"
#include "percolith/simulation/report.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace percolith::io {

/// Writes what a simulation reports into a run's folder: `history.csv`, `probes/<name>.csv`,
/// `matrix.pvd` and, from the first frame with an open crack on, `cracks.pvd`, with their files
/// under `fields/`; `events.csv` from the first call of on_events on, even where it tells of no
/// event, and `fragments.csv` likewise. Every call leaves complete lines and complete files; it
/// throws FileError where the system refuses.
class ResultsWriter : public simulation::Observer {
public:
  /// `folder` exists.
  explicit ResultsWriter(std::filesystem::path folder);
  void on_history(const simulation::HistoryRow& row) override;
  void on_frame(const simulation::Frame& frame) override;
  void on_probes(double time, const std::vector<simulation::ProbeSample>& samples) override;
  void on_events(const std::vector<simulation::BreakEvent>& events) override;
  void on_fragments(double time, const std::vector<simulation::FragmentRow>& rows) override;

  /// How far the files have come. A reading archive only remembers it, and throws FileError where a
  /// table is shorter than it was or a file of fields is gone; `on_resume` cuts tables, collections
  /// and fields back to it.
  void describe_state(StateArchive& archive);
  void on_resume(double time, std::int64_t step) override;
  /// Returns when all that was written has reached the disk. Throws FileError.
  void sync();

private:
  /// The table of this name, relative to the folder; a new one starts with what `header` gives.
  template <class Header>
  AppendFile& table(const std::string& name, const Header& header);

  void remove_later_fields() const;

  std::filesystem::path folder_;
  std::map<std::string, AppendFile> tables_;  // by name, relative to the folder
  TimeSeries matrix_series_;
  TimeSeries crack_series_;
  int frames_ = 0;
  std::map<std::string, std::int64_t> kept_;  // sizes of the tables to go on with
  std::vector<std::string> new_fields_;       // since the last sync
};

}  // namespace percolith::io
