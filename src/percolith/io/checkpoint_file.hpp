// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/archive.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace percolith::io {

/// What a checkpoint belongs to. All of it must be the same where a run goes on.
struct CheckpointOrigin {
  std::string program;    ///< version, revision and flags: other code gives other bits
  std::string case_hash;  ///< of the text of `resolved.toml`
  std::string mesh_hash;  ///< see `mesh::hash_of`
  std::string case_file;  ///< as named on the command line; told by the summary, not compared
  std::vector<std::string> warnings{};  ///< of the case file, with their places; likewise
};

/// Writes `path` through an AtomicFile, synced: a line that says what it is, the origin, what
/// `state` walks through, and at the end the length of all this and a checksum. Throws FileError;
/// then an earlier checkpoint is untouched.
void write_checkpoint(const std::filesystem::path& path, const CheckpointOrigin& origin,
                      const std::function<void(StateArchive&)>& state);

/// A checkpoint that was read whole and found sound.
class CheckpointFile {
public:
  /// Throws FileError where the file cannot be read, is no checkpoint, is of another format, is cut
  /// short or holds other bytes than were written.
  explicit CheckpointFile(const std::filesystem::path& path);
  [[nodiscard]] const CheckpointOrigin& origin() const { return origin_; }
  /// Throws FileError, which says what differs, unless the origin of this checkpoint is `present`.
  void require_origin(const CheckpointOrigin& present) const;
  /// Gives the state; valid as long as this object.
  [[nodiscard]] StateReader state() const;

private:
  std::string name_;
  std::string bytes_;
  std::string_view state_;
  CheckpointOrigin origin_;
};

}  // namespace percolith::io
