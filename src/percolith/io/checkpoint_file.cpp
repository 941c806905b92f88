// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/checkpoint_file.hpp"

#include "percolith/core/error.hpp"
#include "percolith/core/hash.hpp"
#include "percolith/io/file_output.hpp"

#include <fmt/format.h>

#include <cstring>

namespace percolith::io {
namespace {

constexpr std::string_view signature = "percolith checkpoint, ";
constexpr int format = 2;
/// Numbers stand as they do in memory, and a machine that orders their bytes differently reads this
/// one as another.
constexpr std::uint32_t byte_order = 0x01020304;
constexpr std::size_t buffer_size = std::size_t{1} << 20U;

std::string first_line() {
  return fmt::format("{}format {}, reals of {} bytes\n", signature, format, sizeof(double));
}

/// What stands at the end of the file.
struct Trailer {
  std::uint64_t length = 0;  // of all before it, bytes
  std::uint64_t checksum = 0;
};

/// Gathers small pieces before they go to the file, and hashes what does.
class HashedFile {
public:
  explicit HashedFile(const std::filesystem::path& path) : file_(path) {
    buffer_.reserve(buffer_size);
  }
  void add(std::string_view bytes) {
    if (buffer_.size() + bytes.size() > buffer_size) {
      flush();
    }
    if (bytes.size() > buffer_size) {
      put(bytes);
    } else {
      buffer_ += bytes;
    }
  }
  void commit() {
    flush();
    const Trailer trailer{length_, hash_.value()};
    file_.write({reinterpret_cast<const char*>(&trailer), sizeof trailer});
    file_.commit(Durability::synced);
  }

private:
  void flush() {
    put(buffer_);
    buffer_.clear();
  }
  void put(std::string_view bytes) {
    file_.write(bytes);
    hash_.add(bytes);
    length_ += bytes.size();
  }
  AtomicFile file_;
  std::string buffer_;
  ByteHash hash_;
  std::uint64_t length_ = 0;
};

template <class Number>
Number number_at(std::string_view bytes, std::size_t place) {
  Number number{};
  std::memcpy(&number, bytes.data() + place, sizeof number);
  return number;
}

[[noreturn]] void refuse(const std::string& name, const std::string& reason) {
  throw FileError(fmt::format("{}: {}; nothing was changed", name, reason));
}

/// Checks all but the origin and returns what stands between first line and trailer.
std::string_view sound_content(const std::string& name, std::string_view bytes) {
  const std::string line = first_line();
  if (!bytes.starts_with(signature)) {
    refuse(name, "this is no checkpoint, or it has lost its start");
  }
  const std::string_view found = bytes.substr(0, bytes.find('\n') + 1);
  if (found != line) {
    refuse(name, fmt::format("this program reads \"{}\", the file says \"{}\"",
                             line.substr(0, line.size() - 1), found.substr(0, line.size() - 1)));
  }
  if (bytes.size() < line.size() + sizeof byte_order + sizeof(Trailer)) {
    refuse(name, "the checkpoint is cut short");
  }
  if (number_at<std::uint32_t>(bytes, line.size()) != byte_order) {
    refuse(name, "the checkpoint comes from a machine that orders the bytes of numbers otherwise");
  }
  const std::string_view content = bytes.substr(0, bytes.size() - sizeof(Trailer));
  const auto trailer = number_at<Trailer>(bytes, content.size());
  if (trailer.length != content.size()) {
    refuse(name, "the checkpoint is cut short, or its end is damaged");
  }
  ByteHash hash;
  hash.add(content);
  if (trailer.checksum != hash.value()) {
    refuse(name, "the checkpoint is damaged: its checksum is not that of its content");
  }
  return content.substr(line.size() + sizeof byte_order);
}

}  // namespace

static void describe_state(StateArchive& archive, CheckpointOrigin& origin) {
  archive("program", origin.program);
  archive("case_hash", origin.case_hash);
  archive("mesh_hash", origin.mesh_hash);
  archive("case_file", origin.case_file);
  archive.of_any_size("warnings", origin.warnings);
}

void write_checkpoint(const std::filesystem::path& path, const CheckpointOrigin& origin,
                      const std::function<void(StateArchive&)>& state) {
  HashedFile file(path);
  file.add(first_line());
  file.add({reinterpret_cast<const char*>(&byte_order), sizeof byte_order});
  StateWriter writer([&](std::string_view bytes) { file.add(bytes); });
  CheckpointOrigin copy = origin;
  writer("origin", copy);
  state(writer);
  file.commit();
}

CheckpointFile::CheckpointFile(const std::filesystem::path& path)
    : name_(path.string()), bytes_(read_file(path)), state_(sound_content(name_, bytes_)) {
  StateReader reader(state_, name_);
  reader("origin", origin_);
  state_ = reader.rest();
}

void CheckpointFile::require_origin(const CheckpointOrigin& present) const {
  if (origin_.program != present.program) {
    refuse(name_, fmt::format("the checkpoint was written by another program, which may come to "
                              "other bits. It was written by\n{}\nand this is\n{}",
                              origin_.program, present.program));
  }
  if (origin_.case_hash != present.case_hash) {
    refuse(name_, "the checkpoint belongs to another case than resolved.toml beside it, or that "
                  "file was changed since");
  }
  if (origin_.mesh_hash != present.mesh_hash) {
    refuse(name_, "the checkpoint belongs to another mesh than that of mesh.file in resolved.toml: "
                  "the file, or the gmsh that meshes it, has changed since");
  }
}

StateReader CheckpointFile::state() const {
  return {state_, name_};
}

}  // namespace percolith::io
