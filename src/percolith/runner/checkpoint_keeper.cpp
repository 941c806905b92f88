// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/runner/checkpoint_keeper.hpp"

#include "percolith/core/hash.hpp"
#include "percolith/runner/version_text.hpp"

#include <fmt/format.h>

namespace percolith::runner {

void CheckpointKeeper::on_checkpoint(const simulation::Checkpoint& checkpoint) {
  results_.sync();
  io::write_checkpoint(directory_.file(io::checkpoint_name), origin_, [&](StateArchive& archive) {
    archive("results", results_);
    checkpoint.state(archive);
  });
}

void CheckpointKeeper::on_resume(double time, std::int64_t step) {
  // It tells of an end that has become void.
  io::remove_file(directory_.file("summary.json"));
  // A kill in the middle of a checkpoint leaves its part.
  io::remove_file(directory_.file(io::checkpoint_name) += ".part");
  tell_(fmt::format("goes on from the checkpoint at time {:.6g} s, step {}", time, step));
}

io::CheckpointOrigin checkpoint_origin(const std::string& resolved_toml,
                                       const std::string& mesh_hash, const std::string& case_file,
                                       const std::vector<std::string>& warnings) {
  ByteHash hash;
  hash.add(resolved_toml);
  return {.program = version_text(),
          .case_hash = hash.text(),
          .mesh_hash = mesh_hash,
          .case_file = case_file,
          .warnings = warnings};
}

}  // namespace percolith::runner
