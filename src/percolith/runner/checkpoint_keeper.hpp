// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/io/checkpoint_file.hpp"
#include "percolith/io/results_writer.hpp"
#include "percolith/io/run_directory.hpp"

#include <functional>
#include <string>

namespace percolith::runner {

/// Keeps the last checkpoint of a run in its folder, with how far its results have come.
class CheckpointKeeper : public simulation::Observer {
public:
  using Tell = std::function<void(const std::string&)>;
  /// All but `origin` must outlive the keeper; `tell` takes a line that says where a run goes on.
  CheckpointKeeper(const io::RunDirectory& directory, io::CheckpointOrigin origin,
                   io::ResultsWriter& results, Tell tell)
      : directory_(directory), origin_(std::move(origin)), results_(results),
        tell_(std::move(tell)) {}

  /// Throws FileError; then the checkpoint before is untouched.
  void on_checkpoint(const simulation::Checkpoint& checkpoint) override;
  void on_resume(double time, std::int64_t step) override;

private:
  const io::RunDirectory& directory_;
  io::CheckpointOrigin origin_;
  io::ResultsWriter& results_;
  Tell tell_;
};

/// What checkpoints of the case with this `resolved.toml` belong to; `warnings` are those of the
/// case file.
[[nodiscard]] io::CheckpointOrigin checkpoint_origin(const std::string& resolved_toml,
                                                     const std::string& mesh_hash,
                                                     const std::string& case_file,
                                                     const std::vector<std::string>& warnings);

}  // namespace percolith::runner
