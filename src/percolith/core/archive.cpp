// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/archive.hpp"

#include "percolith/core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace percolith {

void StateWriter::bytes(void* data, std::size_t size) {
  sink_({static_cast<const char*>(data), size});
}

void StateWriter::begin(std::string_view name) {
  if (depth_ == 0) {
    size_of(name.size());
    sink_(name);
  }
}

std::uint64_t StateWriter::size_of(std::uint64_t present) {
  bytes(&present, sizeof present);
  return present;
}

void StateReader::fail(const std::string& reason) const {
  std::string path;
  for (const std::string& name : path_) {
    path += path.empty() ? name : "." + name;
  }
  throw FileError(fmt::format("{}: {}: {}", origin_, path.empty() ? "state" : path, reason));
}

void StateReader::bytes(void* data, std::size_t size) {
  if (size > rest_.size()) {
    fail("the file ends too early");
  }
  if (size > 0) {
    std::memcpy(data, rest_.data(), size);
    rest_.remove_prefix(size);
  }
}

void StateReader::begin(std::string_view name) {
  path_.emplace_back(name);
  if (depth_ > 0) {
    return;
  }
  const std::uint64_t size = next_size();
  const std::string_view found = rest_.substr(0, std::min<std::size_t>(size, rest_.size()));
  if (found != name) {
    fail("another value stands in its place");
  }
  rest_.remove_prefix(found.size());
}

std::uint64_t StateReader::next_size() {
  std::uint64_t size = 0;
  bytes(&size, sizeof size);
  // Every element takes a byte at least: what cannot be there need not be given room.
  if (size > rest_.size()) {
    fail(fmt::format("{} elements do not fit into the rest of the file", size));
  }
  return size;
}

std::uint64_t StateReader::size_of(std::uint64_t /*present*/) {
  return next_size();
}

void StateReader::require_size(std::uint64_t present) {
  const std::uint64_t size = next_size();
  if (size != present) {
    fail(fmt::format("{} values stand there, the model has {}", size, present));
  }
}

}  // namespace percolith
