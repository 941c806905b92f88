// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/runner/case_run.hpp"

#include "percolith/core/error.hpp"
#include "percolith/io/summary.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <exception>
#include <string_view>
#include <utility>

namespace percolith::runner {
namespace {

std::unique_ptr<io::CheckpointFile> last_checkpoint(const io::RunDirectory& directory) {
  const std::filesystem::path file = directory.file(io::checkpoint_name);
  if (!std::filesystem::exists(file)) {
    throw InputError({{},
                      "--resume",
                      directory.path().string(),
                      fmt::format("the folder holds no {}: the run was ended before its first "
                                  "checkpoint, or is a steady one",
                                  io::checkpoint_name),
                      "a run that left a checkpoint; see output.checkpoint_interval"});
  }
  return std::make_unique<io::CheckpointFile>(file);
}

/// Where the command line names itself as the place of an option, which Python sets otherwise.
constexpr std::string_view place_of_overrides = "--set: ";

void use_threads(std::optional<int> threads) {
  if (threads) {
    omp_set_num_threads(*threads);
  }
}

}  // namespace

std::unique_ptr<CaseRun> CaseRun::start(const RunRequest& request, Console console) {
  if (request.output) {
    io::RunDirectory::require_usable(*request.output, request.existing);
  }
  use_threads(request.threads);
  LoadedModel model = load_model(request.source);
  if (console.is_python) {
    for (std::string& warning : model.read_case.warnings) {
      warning.erase(0, warning.starts_with(place_of_overrides) ? place_of_overrides.size() : 0);
    }
  }
  std::optional<io::RunDirectory> directory;
  if (request.output) {
    directory = io::RunDirectory::open(*request.output, request.existing);
  }
  // Its parts refer to each other: it stays where it is.
  std::unique_ptr<CaseRun> run(new CaseRun(request.source, std::move(model), std::move(directory)));
  if (run->directory_) {
    run->recorder_.emplace(*run->directory_, request.source.file.string(), run->model_,
                           RecorderOptions{request.quiet, std::move(console)});
  }
  return run;
}

std::unique_ptr<CaseRun> CaseRun::reopen(const std::filesystem::path& folder,
                                         std::optional<int> threads, bool quiet, Console console) {
  io::RunDirectory directory = io::RunDirectory::reopen(folder);
  if (io::has_finished(directory.path())) {
    // It may have been killed in between.
    directory.remove_checkpoint();
    return nullptr;
  }
  std::unique_ptr<io::CheckpointFile> checkpoint = last_checkpoint(directory);
  use_threads(threads);
  const std::filesystem::path case_file = directory.file("resolved.toml");
  const std::string resolved = io::read_file(case_file);
  // Before the model is built, which may fail for what the next line tells better.
  const io::CheckpointOrigin& written = checkpoint->origin();
  io::CheckpointOrigin origin =
      checkpoint_origin(resolved, written.mesh_hash, written.case_file, written.warnings);
  checkpoint->require_origin(origin);
  const CaseSource source{case_file, {}, {}};
  LoadedModel model = load_model(source);
  // resolved.toml names every option: what its text is warned of is not what the case was.
  model.read_case.warnings = origin.warnings;
  origin.mesh_hash = model.mesh_hash;
  checkpoint->require_origin(origin);

  std::unique_ptr<CaseRun> run(new CaseRun(source, std::move(model), std::move(directory)));
  run->checkpoint_ = std::move(checkpoint);
  run->state_.emplace(run->checkpoint_->state());
  run->recorder_.emplace(*run->directory_, origin, run->model_,
                         RecorderOptions{quiet, std::move(console)});
  run->recorder_->read_state(*run->state_);
  return run;
}

template <class Work>
auto CaseRun::guarded(const Work& work) {
  try {
    return work();
  } catch (const std::exception& error) {
    if (recorder_) {
      recorder_->fail(error.what());
    }
    release();
    throw;
  }
}

void CaseRun::release() {
  recorder_.reset();
  directory_.reset();
}

void CaseRun::start_from(const simulation::StartingMotion& start) {
  if (observer_ || recorder_) {
    throw InputError({{},
                      start.displacement.empty() ? "velocity" : "displacement",
                      "",
                      observer_ ? "the run has begun" : "the run writes results",
                      "a run without results, before its first step"});
  }
  LoadedModel again = load_model(source_, start);
  former_.push_back(std::move(model_.simulation));
  model_.simulation = std::move(again.simulation);
}

void CaseRun::set_condition(const std::string& path, double value) {
  simulation().set_condition(path, value);
  if (recorder_) {
    recorder_->note(
        fmt::format("at time {:.9g} s {} was set to {:.9g}", simulation().time(), path, value));
  }
}

void CaseRun::begin() {
  if (recorder_) {
    observers_.insert(observers_.begin(), &recorder_->observer());
  }
  observer_ = std::make_unique<io::Observers>(observers_);
  guarded([&] {
    if (state_) {
      simulation().begin_from(*state_, *observer_);
    } else {
      simulation().begin(*observer_);
    }
  });
}

simulation::Reached CaseRun::advance(const std::function<bool()>& stop,
                                     const simulation::Pause& pause) {
  const auto reached = guarded([&] { return simulation().advance(*observer_, stop, pause); });
  if (reached == simulation::Reached::end && recorder_) {
    recorder_->finish();
  }
  if (reached == simulation::Reached::end) {
    release();
  }
  return reached;
}

void CaseRun::interrupt(const std::string& by) {
  if (recorder_) {
    recorder_->interrupt(by);
  }
  release();
}

void CaseRun::leave(const std::string& by) {
  guarded([&] { simulation().leave(*observer_); });
  interrupt(by);
}

}  // namespace percolith::runner
