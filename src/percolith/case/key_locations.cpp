// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/key_locations.hpp"

#include <fmt/format.h>

namespace percolith::case_file {

Written KeyLocations::nearest(const std::string& key) const {
  const auto exact = written_.find(key);
  if (exact != written_.end()) {
    return exact->second;
  }
  std::string path = key;
  // An element of a list, as in `groups[0]`, belongs to its option.
  for (std::size_t end = path.find_last_of(".["); end != std::string::npos;
       end = path.find_last_of(".[")) {
    path.resize(end);
    const auto holder = written_.find(path);
    if (holder != written_.end()) {
      return {holder->second.location, {}};
    }
  }
  return {file_, {}};
}

std::string to_text(const FileLocation& at) {
  return at.line > 0 ? fmt::format("{}:{}:{}", at.file, at.line, at.column) : at.file;
}

}  // namespace percolith::case_file
