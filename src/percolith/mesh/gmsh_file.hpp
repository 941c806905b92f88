// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

namespace percolith::mesh {

/// All bytes of a file.
struct FileContent {
  std::unique_ptr<char[]> bytes;
  std::size_t size = 0;
  [[nodiscard]] std::string_view view() const { return {bytes.get(), size}; }
};

/// Throws FileError when a file is missing or not a plain file.
void require_plain_file(const std::filesystem::path& path);

/// Reads a file in one go. Throws FileError when it is missing, not a plain file or unreadable.
[[nodiscard]] FileContent read_whole_file(const std::filesystem::path& path);

}  // namespace percolith::mesh
