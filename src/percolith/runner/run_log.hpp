// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/report.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace percolith::runner {

/// The log of a run (`run.log`), one dated line an event, each on disk before the call returns.
/// Warnings are also shown to the user. Throws FileError where a line cannot be written.
class RunLog : public simulation::Observer {
public:
  using Show = std::function<void(const std::string&)>;  ///< shows a line to the user
  RunLog(const std::filesystem::path& file, Show show);
  ~RunLog() override;
  RunLog(const RunLog&) = delete;
  RunLog& operator=(const RunLog&) = delete;

  void information(const std::string& text);
  void error(const std::string& text);
  void on_warning(const std::string& text) override;
  /// A warning of the case file, which says itself where it belongs.
  void on_located_warning(const std::string& text);
  void on_checkpoint(const simulation::Checkpoint& checkpoint) override;
  void on_probes(double time, const std::vector<simulation::ProbeSample>& samples) override;

private:
  struct Sink;
  std::unique_ptr<Sink> sink_;
  std::filesystem::path file_;
  Show show_;
};

}  // namespace percolith::runner
