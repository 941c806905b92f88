// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/gmsh_file.hpp"

#include "percolith/core/error.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace percolith::mesh {
namespace {

[[noreturn]] void fail_file(const std::filesystem::path& path, const std::string& reason) {
  throw FileError(fmt::format("{}: error: mesh.file: {}", path.string(), reason));
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

void require_plain_file(const std::filesystem::path& path) {
  std::error_code problem;
  const std::filesystem::file_status status = std::filesystem::status(path, problem);
  if (status.type() == std::filesystem::file_type::not_found) {
    fail_file(path, "there is no such file");
  }
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    fail_file(path, "this is not a plain file");
  }
}

FileContent read_whole_file(const std::filesystem::path& path) {
  require_plain_file(path);
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  if (!file) {
    fail_file(path, fmt::format("the file cannot be opened: {}", std::strerror(errno)));
  }
  std::error_code problem;
  const std::uintmax_t size = std::filesystem::file_size(path, problem);
  if (problem) {
    fail_file(path, fmt::format("the file cannot be read: {}", problem.message()));
  }
  FileContent content;
  content.size = static_cast<std::size_t>(size);
  content.bytes = std::make_unique_for_overwrite<char[]>(content.size);
  if (std::fread(content.bytes.get(), 1, content.size, file.get()) != content.size) {
    fail_file(path, fmt::format("the file cannot be read to its end: {}", std::strerror(errno)));
  }
  return content;
}

}  // namespace percolith::mesh
