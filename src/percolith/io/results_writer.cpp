// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/results_writer.hpp"

#include "percolith/io/csv.hpp"
#include "percolith/io/events.hpp"
#include "percolith/io/field_files.hpp"
#include "percolith/io/fragments.hpp"
#include "percolith/io/history.hpp"
#include "percolith/io/probes.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string_view>
#include <system_error>
#include <utility>

namespace percolith::io {
namespace {

std::string field_file(const char* series, int frame) {
  return fmt::format("fields/{}_{:06}.vtu", series, frame);
}

/// Number of the frame that a file of fields, complete or not, belongs to; -1 for other files.
int frame_of(std::string_view name) {
  int frame = -1;
  for (const std::string_view series : {"matrix_", "cracks_"}) {
    if (name.starts_with(series) && (name.ends_with(".vtu") || name.ends_with(".vtu.part"))) {
      std::from_chars(name.data() + series.size(), name.data() + name.size(), frame);
    }
  }
  return frame;
}

}  // namespace

ResultsWriter::ResultsWriter(std::filesystem::path folder)
    : folder_(std::move(folder)), matrix_series_(folder_ / "matrix.pvd"),
      crack_series_(folder_ / "cracks.pvd") {}

template <class Header>
AppendFile& ResultsWriter::table(const std::string& name, const Header& header) {
  auto file = tables_.find(name);
  if (file == tables_.end()) {
    make_folder((folder_ / name).parent_path());
    file = tables_.try_emplace(name, folder_ / name).first;
    file->second.append(header());
  }
  return file->second;
}

void ResultsWriter::on_history(const simulation::HistoryRow& row) {
  table("history.csv", [&] { return history_header(row); }).append(history_line(row));
}

void ResultsWriter::on_frame(const simulation::Frame& frame) {
  make_folder(folder_ / "fields");
  const std::string matrix = field_file("matrix", frames_);
  write_matrix(folder_ / matrix, frame.time, frame.matrix);
  new_fields_.push_back(matrix);
  matrix_series_.add(frame.time, matrix);
  if (!frame.cracks.segments.empty()) {
    const std::string cracks = field_file("cracks", frames_);
    write_cracks(folder_ / cracks, frame.time, frame.cracks);
    new_fields_.push_back(cracks);
    crack_series_.add(frame.time, cracks);
  }
  ++frames_;
}

void ResultsWriter::on_probes(double time, const std::vector<simulation::ProbeSample>& samples) {
  for (const simulation::ProbeSample& sample : samples) {
    table("probes/" + file_name_of(sample.name) + ".csv", [&] {
      return probe_header(sample);
    }).append(probe_lines(time, sample));
  }
}

void ResultsWriter::on_events(const std::vector<simulation::BreakEvent>& events) {
  table("events.csv", events_header).append(event_lines(events));
}

void ResultsWriter::on_fragments(double time, const std::vector<simulation::FragmentRow>& rows) {
  table("fragments.csv", fragments_header).append(fragment_lines(time, rows));
}

void ResultsWriter::describe_state(StateArchive& archive) {
  std::map<std::string, std::int64_t> sizes;
  for (const auto& [name, file] : tables_) {
    sizes[name] = file.size();
  }
  archive("tables", sizes);
  archive("frames", frames_);
  archive("matrix_series", matrix_series_);
  archive("crack_series", crack_series_);
  if (archive.reads()) {
    for (const auto& [name, size] : sizes) {
      require_size(folder_ / name, size);
    }
    for (const TimeSeries* series : {&matrix_series_, &crack_series_}) {
      for (const std::string& name : series->files()) {
        require_size(folder_ / name, 1);
      }
    }
    kept_ = std::move(sizes);
  }
}

void ResultsWriter::on_resume(double /*time*/, std::int64_t /*step*/) {
  for (const auto& [name, size] : kept_) {
    tables_.try_emplace(name, folder_ / name, size);
  }
  remove_later_fields();
  matrix_series_.write();
  crack_series_.write();
}

void ResultsWriter::remove_later_fields() const {
  std::error_code none;  // no folder, no fields
  std::vector<std::filesystem::path> later;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "fields", none)) {
    if (frame_of(entry.path().filename().string()) >= frames_) {
      later.push_back(entry.path());
    }
  }
  for (const std::filesystem::path& file : later) {
    remove_file(file);
  }
}

void ResultsWriter::sync() {
  for (const std::string& name : new_fields_) {
    io::sync(folder_ / name);
  }
  new_fields_.clear();
  for (const auto& [name, file] : tables_) {
    io::sync(folder_ / name);
  }
}

}  // namespace percolith::io
