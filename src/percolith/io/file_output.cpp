// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/file_output.hpp"

#include "percolith/core/error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>

namespace percolith::io {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const char* action, int error_number) {
  std::string help;
  if (error_number == ENOSPC || error_number == EDQUOT) {
    help = "; free some space or choose another --output";
  } else if (error_number == EFBIG) {
    help = "; raise the file size limit (ulimit -f)";
  }
  throw FileError(fmt::format("{}: cannot {} the file: {}{}", path.string(), action,
                              std::generic_category().message(error_number), help));
}

int open_new(const std::filesystem::path& path) {
  const int number = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (number < 0) {
    fail(path, "open", errno);
  }
  return number;
}

// Returns 0, or the error number of the write that failed.
int write_all(int number, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(number, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) {
      return errno;
    }
    if (count > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
  }
  return 0;
}

}  // namespace

FileDescriptor::FileDescriptor(FileDescriptor&& other) noexcept
    : number_(std::exchange(other.number_, -1)) {}

FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
  if (this != &other) {
    close();
    number_ = std::exchange(other.number_, -1);
  }
  return *this;
}

FileDescriptor::~FileDescriptor() {
  close();
}

bool FileDescriptor::close() {
  const int number = std::exchange(number_, -1);
  return number < 0 || ::close(number) == 0;
}

AtomicFile::AtomicFile(std::filesystem::path path)
    : path_(std::move(path)), part_(path_.string() + ".part"), file_(open_new(part_)) {}

AtomicFile::~AtomicFile() {
  if (!part_.empty()) {
    ::unlink(part_.c_str());
  }
}

void AtomicFile::write(std::string_view bytes) {
  if (const int error_number = write_all(file_.number(), bytes); error_number != 0) {
    fail(path_, "write", error_number);
  }
}

void AtomicFile::commit(Durability durability) {
  if (durability == Durability::synced && ::fsync(file_.number()) != 0 && errno != EINVAL &&
      errno != ENOTSUP) {
    fail(path_, "write", errno);
  }
  if (!file_.close()) {
    fail(path_, "write", errno);
  }
  if (::rename(part_.c_str(), path_.c_str()) != 0) {
    fail(path_, "replace", errno);
  }
  part_.clear();
  if (durability == Durability::synced) {
    sync(path_.has_parent_path() ? path_.parent_path() : ".");
  }
}

std::string read_file(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) {
    throw FileError(fmt::format("{}: cannot read the file", path.string()));
  }
  return bytes;
}

void sync(const std::filesystem::path& path) {
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) {
    fail(path, "open", errno);
  }
  // What cannot be synced, as some devices and network folders, needs no syncing.
  if (::fsync(file.number()) != 0 && errno != EINVAL && errno != ENOTSUP) {
    fail(path, "write", errno);
  }
}

void write_file(const std::filesystem::path& path, std::string_view text, Durability durability) {
  AtomicFile file(path);
  file.write(text);
  file.commit(durability);
}

AppendFile::AppendFile(std::filesystem::path path)
    : path_(std::move(path)), file_(open_new(path_)) {}

AppendFile::AppendFile(std::filesystem::path path, std::int64_t size)
    : path_(std::move(path)), size_(size) {
  require_size(path_, size);
  file_ = FileDescriptor(::open(path_.c_str(), O_WRONLY | O_CLOEXEC));
  if (!file_.is_open()) {
    fail(path_, "open", errno);
  }
  if (::ftruncate(file_.number(), size) != 0 || ::lseek(file_.number(), size, SEEK_SET) != size) {
    fail(path_, "cut", errno);
  }
}

void AppendFile::append(std::string_view lines) {
  if (const int error_number = write_all(file_.number(), lines); error_number != 0) {
    // A device cannot be cut; the error of the write is the one to tell.
    [[maybe_unused]] const int cut = ::ftruncate(file_.number(), size_);
    fail(path_, "write", error_number);
  }
  size_ += static_cast<std::int64_t>(lines.size());
}

void require_size(const std::filesystem::path& path, std::int64_t size) {
  std::error_code error;
  const auto present = std::filesystem::file_size(path, error);
  if (error) {
    fail(path, "go on with", error.value());
  }
  if (static_cast<std::int64_t>(present) < size) {
    throw FileError(fmt::format("{}: the file has {} bytes, {} are needed to go on: it was changed "
                                "since the checkpoint",
                                path.string(), present, size));
  }
}

bool remove_file(const std::filesystem::path& path) {
  std::error_code error;
  const bool removed = std::filesystem::remove(path, error);
  if (error) {
    fail(path, "remove", error.value());
  }
  return removed;
}

void make_folder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) {
    throw FileError(fmt::format("{}: cannot make the folder: {}", path.string(), error.message()));
  }
}

}  // namespace percolith::io
