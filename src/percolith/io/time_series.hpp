// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/archive.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace percolith::io {

/// A ParaView collection (`.pvd`): the files of a field series with their times. It is written
/// anew after each frame, so that it lists complete files at any moment.
class TimeSeries {
public:
  /// `path` of the collection; nothing is written yet.
  explicit TimeSeries(std::filesystem::path path) : path_(std::move(path)) {}
  /// Adds `file`, relative to the collection, at `time` in s and writes the collection.
  /// Throws FileError; the collection written before then stays.
  void add(double time, const std::string& file);
  /// The files it lists, in the order of time.
  [[nodiscard]] std::vector<std::string> files() const;
  void describe_state(StateArchive& archive) { archive("entries", entries_); }
  /// Writes the collection as it is now, or removes it where it has no files. Throws FileError.
  void write() const;

private:
  std::filesystem::path path_;
  std::string entries_;
};

}  // namespace percolith::io
