// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/runner/run_log.hpp"

#include "percolith/core/error.hpp"

#include <fmt/format.h>
#include <spdlog/logger.h>
#include <spdlog/sinks/basic_file_sink.h>

#include <utility>

namespace percolith::runner {
namespace {

std::shared_ptr<spdlog::sinks::sink> open_sink(const std::filesystem::path& file) {
  try {
    return std::make_shared<spdlog::sinks::basic_file_sink_st>(file.string());
  } catch (const spdlog::spdlog_ex& error) {
    throw FileError(fmt::format("{}: cannot open the log: {}", file.string(), error.what()));
  }
}

}  // namespace

struct RunLog::Sink {
  explicit Sink(const std::filesystem::path& file) : logger("run", open_sink(file)) {
    logger.set_pattern("%Y-%m-%dT%H:%M:%S%z %l: %v");
    logger.flush_on(spdlog::level::info);
    logger.set_error_handler([this](const std::string& text) { problem = text; });
  }
  spdlog::logger logger;
  std::string problem;  // what went wrong in the last call, empty when nothing

  void write(spdlog::level::level_enum level, const std::string& text,
             const std::filesystem::path& file) {
    logger.log(level, text);
    if (!problem.empty()) {
      throw FileError(
          fmt::format("{}: cannot write the log: {}", file.string(), std::exchange(problem, {})));
    }
  }
};

RunLog::RunLog(const std::filesystem::path& file, Show show)
    : sink_(std::make_unique<Sink>(file)), file_(file), show_(std::move(show)) {}

RunLog::~RunLog() = default;

void RunLog::information(const std::string& text) {
  sink_->write(spdlog::level::info, text, file_);
}

void RunLog::error(const std::string& text) {
  sink_->write(spdlog::level::err, text, file_);
}

void RunLog::on_warning(const std::string& text) {
  show_("warning: " + text);
  sink_->write(spdlog::level::warn, text, file_);
}

void RunLog::on_located_warning(const std::string& text) {
  show_(text);
  sink_->write(spdlog::level::warn, text, file_);
}

void RunLog::on_checkpoint(const simulation::Checkpoint& checkpoint) {
  information(fmt::format("checkpoint at time {} s", checkpoint.time));
}

// Probes come with every output, even where none are asked for.
void RunLog::on_probes(double time, const std::vector<simulation::ProbeSample>&) {
  information(fmt::format("output at time {} s", time));
}

}  // namespace percolith::runner
