// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/runner/run_recorder.hpp"

#include "percolith/case/documents.hpp"
#include "percolith/runner/derived_values.hpp"
#include "percolith/runner/finish_text.hpp"
#include "percolith/runner/version_text.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <chrono>
#include <vector>

namespace percolith::runner {
namespace {

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Reading the case and building the model came before the recorder.
double started_at(const LoadedModel& model) {
  double started = seconds_now();
  for (const auto& [phase, seconds] : model.wall_time) {
    started -= seconds;
  }
  return started;
}

io::RunRecord record_of(const std::string& case_file, const LoadedModel& model) {
  io::RunRecord record;
  record.version = version_and_revision();
  record.case_file = case_file;
  record.title = model.read_case.setup.title;
  record.threads = omp_get_max_threads();
  record.processor = io::processor_name();
  record.regions = model.simulation.region_names();
  record.fractures = model.simulation.fracture_names();
  record.warnings = model.read_case.warnings;
  return record;
}

std::string resolved_case(const LoadedModel& model) {
  simulation::Setup setup = model.read_case.setup;
  // The copy stands in another folder than the case file.
  setup.mesh.file = std::filesystem::absolute(model.read_case.directory / setup.mesh.file)
                        .lexically_normal()
                        .string();
  return case_file::resolved_toml(setup,
                                  derived_values(model.simulation.check(), version_and_revision()));
}

io::ProgressLine progress_line(const Console& console) {
  const auto style = console.is_terminal ? io::ProgressStyle::terminal : io::ProgressStyle::plain;
  return {style, console.width, console.print, seconds_now};
}

std::vector<simulation::Observer*> chosen(io::ResultsWriter& results, CheckpointKeeper& keeper,
                                          RunLog& log, io::ProgressLine& progress, bool is_quiet) {
  // A checkpoint tells how far the results have come: they come first.
  std::vector<simulation::Observer*> observers = {&results, &keeper, &log};
  if (!is_quiet) {
    observers.push_back(&progress);
  }
  return observers;
}

}  // namespace

RunRecorder::RunRecorder(const io::RunDirectory& directory, const std::string& case_file,
                         const LoadedModel& model, const RecorderOptions& options)
    : RunRecorder(directory, case_file, model, options, resolved_case(model)) {}

RunRecorder::RunRecorder(const io::RunDirectory& directory, const std::string& case_file,
                         const LoadedModel& model, const RecorderOptions& options,
                         const std::string& resolved)
    : RunRecorder(directory,
                  checkpoint_origin(resolved, model.mesh_hash, case_file, model.read_case.warnings),
                  model, options) {
  has_begun_ = true;
  io::write_file(directory.file("resolved.toml"), resolved, io::Durability::synced);
  log_.information(fmt::format("percolith {} runs {} on {} threads of {}", record_.version,
                               record_.case_file, record_.threads, record_.processor));
  for (const std::string& warning : model.read_case.warnings) {
    log_.on_located_warning(warning);
  }
}

RunRecorder::RunRecorder(const io::RunDirectory& directory, const io::CheckpointOrigin& origin,
                         const LoadedModel& model, const RecorderOptions& options)
    : directory_(directory), model_(model), started_(started_at(model)), options_(options),
      record_(record_of(origin.case_file, model)), results_(directory.path()),
      progress_(progress_line(options.console)), log_(directory.file("run.log"),
                                                      [this](const std::string& line) {
                                                        progress_.clear();
                                                        options_.console.alert(line);
                                                      }),
      keeper_(directory, origin, results_,
              [this](const std::string& line) {
                has_begun_ = true;
                log_.information(fmt::format("percolith {} {} on {} threads of {}", record_.version,
                                             line, record_.threads, record_.processor));
                say(line);
              }),
      observers_(chosen(results_, keeper_, log_, progress_, options.quiet)) {}

void RunRecorder::say(const std::string& text) {
  progress_.clear();
  if (!options_.quiet) {
    options_.console.print(text + '\n');
  }
}

void RunRecorder::write_summary(io::Outcome outcome, const std::string& reason) {
  record_.outcome = outcome;
  record_.reason = reason;
  std::map<std::string, double> wall_time = model_.wall_time;
  wall_time["total"] = seconds_now() - started_;
  io::write_file(directory_.file("summary.json"),
                 io::summary_json(record_, model_.simulation.summary(), wall_time),
                 io::Durability::synced);
}

void RunRecorder::finish() {
  write_summary(io::Outcome::finished, "");
  directory_.remove_checkpoint();
  const simulation::Setup& setup = model_.read_case.setup;
  const bool is_steady = setup.model.physics == simulation::Physics::seepage &&
                         setup.time.scheme == simulation::Scheme::steady;
  const simulation::Summary summary = model_.simulation.summary();
  std::vector<std::string> lines = result_lines(summary);
  lines.push_back(finish_text(summary, is_steady, directory_.path()));
  for (const std::string& line : lines) {
    log_.information(line);
    say(line);
  }
}

void RunRecorder::interrupt(const std::string& by) {
  write_summary(io::Outcome::interrupted, by);
  const std::string folder = directory_.path().string();
  const std::string call = options_.console.is_python
                               ? fmt::format("percolith.resume(\"{}\"), or ", folder)
                               : std::string();
  const std::string text =
      fmt::format("interrupted by {} at time {:.6g} s; results so far in {}; to go on: {}percolith "
                  "run --resume {}",
                  by, model_.simulation.summary().end_time, folder, call, folder);
  log_.information(text);
  progress_.clear();
  options_.console.alert(text);
}

void RunRecorder::fail(const std::string& reason) noexcept {
  try {
    progress_.clear();
    if (has_begun_) {
      write_summary(io::Outcome::failed, reason);
    }
    log_.error(reason);
  } catch (...) {
    return;
  }
}

}  // namespace percolith::runner
