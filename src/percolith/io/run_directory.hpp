// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/io/file_output.hpp"

#include <filesystem>

namespace percolith::io {

/// What to do with results that stand where new ones should go.
enum class Existing { refuse, replace };

/// Where a run keeps the moment to go on from.
inline constexpr const char* checkpoint_name = "checkpoint.bin";

/// The folder of one run, held against other runs as long as this object lives (a lock on its
/// `run.log`, which goes with the process).
class RunDirectory {
public:
  /// `<name of the case file without extension>.results` in the current folder.
  [[nodiscard]] static std::filesystem::path default_path(const std::filesystem::path& case_file);

  /// Throws the InputError that `open` would throw, and touches nothing: to be called before the
  /// model is built, so that a long set-up does not end in a refusal.
  static void require_usable(const std::filesystem::path& path, Existing existing);

  /// Makes the folder or takes over an empty one. One with content is refused (InputError with
  /// key `--output`), unless `existing` is `replace` and it holds a run's results: then the files
  /// a run writes are removed, and all others stay; `resolved.toml` stays for the run to replace. A
  /// folder that another run is writing to is always refused. Throws FileError where the system
  /// does not allow it.
  static RunDirectory open(const std::filesystem::path& path, Existing existing);

  /// Takes over the folder of a run that is to go on; changes nothing. Throws InputError (key
  /// `--resume`) where it holds no run, or another run is writing to it.
  static RunDirectory reopen(const std::filesystem::path& path);

  /// Removes the checkpoint of a run that has come to its end. Throws FileError.
  void remove_checkpoint() const;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path file(const char* name) const { return path_ / name; }

private:
  RunDirectory(std::filesystem::path path, FileDescriptor lock)
      : path_(std::move(path)), lock_(std::move(lock)) {}
  std::filesystem::path path_;
  FileDescriptor lock_;
};

}  // namespace percolith::io
