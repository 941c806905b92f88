// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/results_writer.hpp"

#include "percolith/io/csv.hpp"
#include "percolith/io/events.hpp"
#include "percolith/io/field_files.hpp"
#include "percolith/io/fragments.hpp"
#include "percolith/io/history.hpp"
#include "percolith/io/probes.hpp"

#include <fmt/format.h>

namespace percolith::io {
ResultsWriter::ResultsWriter(std::filesystem::path folder, bool has_cracks)
    : folder_(std::move(folder)), has_cracks_(has_cracks), matrix_series_(folder_ / "matrix.pvd"),
      crack_series_(folder_ / "cracks.pvd") {}

void ResultsWriter::on_history(const simulation::HistoryRow& row) {
  if (!history_) {
    history_.emplace(folder_ / "history.csv");
    history_->append(history_header(row));
  }
  history_->append(history_line(row, has_cracks_));
}

void ResultsWriter::on_frame(const simulation::Frame& frame) {
  make_folder(folder_ / "fields");
  const std::string matrix = fmt::format("fields/matrix_{:06}.vtu", frames_);
  write_matrix(folder_ / matrix, frame.time, frame.matrix);
  matrix_series_.add(frame.time, matrix);
  if (!frame.cracks.segments.empty()) {
    const std::string cracks = fmt::format("fields/cracks_{:06}.vtu", frames_);
    write_cracks(folder_ / cracks, frame.time, frame.cracks);
    crack_series_.add(frame.time, cracks);
  }
  ++frames_;
}

void ResultsWriter::on_probes(double time, const std::vector<simulation::ProbeSample>& samples) {
  for (const simulation::ProbeSample& sample : samples) {
    auto file = probes_.find(sample.name);
    if (file == probes_.end()) {
      make_folder(folder_ / "probes");
      const std::string name = file_name_of(sample.name) + ".csv";
      file = probes_.try_emplace(sample.name, folder_ / "probes" / name).first;
      file->second.append(probe_header(sample));
    }
    file->second.append(probe_lines(time, sample));
  }
}

void ResultsWriter::on_events(const std::vector<simulation::BreakEvent>& events) {
  if (!events_) {
    events_.emplace(folder_ / "events.csv");
    events_->append(events_header());
  }
  events_->append(event_lines(events));
}

void ResultsWriter::on_fragments(double time, const std::vector<simulation::FragmentRow>& rows) {
  if (!fragments_) {
    fragments_.emplace(folder_ / "fragments.csv");
    fragments_->append(fragments_header());
  }
  fragments_->append(fragment_lines(time, rows));
}

}  // namespace percolith::io
