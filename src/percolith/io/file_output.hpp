// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

// Files a run writes. Every system call is checked: a full disk ends in a FileError that names the
// file, and what stood there before is kept.
namespace percolith::io {

/// An open file descriptor, closed at the end of its life.
class FileDescriptor {
public:
  FileDescriptor() = default;
  explicit FileDescriptor(int number) : number_(number) {}
  FileDescriptor(FileDescriptor&& other) noexcept;
  FileDescriptor& operator=(FileDescriptor&& other) noexcept;
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  ~FileDescriptor();
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] bool is_open() const { return number_ >= 0; }
  /// Closes now; returns false where the system reports a late write error.
  bool close();

private:
  int number_ = -1;
};

/// Whether a file must have reached the disk before the call returns.
enum class Durability { buffered, synced };

/// A file that appears under its name only when it is complete: it is written as `<path>.part`
/// and renamed by `commit`. Without `commit` the part is removed and an earlier file stays.
class AtomicFile {
public:
  /// Throws FileError where the part cannot be made.
  explicit AtomicFile(std::filesystem::path path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();
  /// Appends `bytes`. Throws FileError (disk full, file size limit).
  void write(std::string_view bytes);
  /// Closes the part and renames it; synced, the new name has reached the disk too. Throws
  /// FileError; then an earlier file is untouched.
  void commit(Durability durability);

private:
  std::filesystem::path path_;
  std::filesystem::path part_;
  FileDescriptor file_;
};

/// The whole content of a file. Throws FileError.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);

/// Returns when what was written to a file or a folder has reached the disk. Throws FileError.
void sync(const std::filesystem::path& path);

/// Writes `text` to `path` through an AtomicFile. Throws FileError.
void write_file(const std::filesystem::path& path, std::string_view text, Durability durability);

/// A table that grows by whole lines. After a failed write the file is cut back to its last
/// complete line.
class AppendFile {
public:
  /// Makes the file, empty. Throws FileError.
  explicit AppendFile(std::filesystem::path path);
  /// Goes on with a file of which the first `size` bytes count: cuts off the others. Throws
  /// FileError where the file is shorter or not there.
  AppendFile(std::filesystem::path path, std::int64_t size);
  /// Bytes up to the last complete line.
  [[nodiscard]] std::int64_t size() const { return size_; }
  /// Appends `lines`, which end in a newline, and hands them to the system. Throws FileError.
  void append(std::string_view lines);

private:
  std::filesystem::path path_;
  FileDescriptor file_;
  std::int64_t size_ = 0;
};

/// Throws FileError unless there is a file of at least `size` bytes.
void require_size(const std::filesystem::path& path, std::int64_t size);

/// Removes a file; false where there is none. Throws FileError.
bool remove_file(const std::filesystem::path& path);

/// Makes a folder and those above it. Throws FileError.
void make_folder(const std::filesystem::path& path);

}  // namespace percolith::io
