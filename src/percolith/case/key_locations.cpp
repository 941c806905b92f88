// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/key_locations.hpp"

namespace percolith::case_file {

Written KeyLocations::nearest(const std::string& key) const {
  const auto exact = written_.find(key);
  if (exact != written_.end()) {
    return exact->second;
  }
  std::string path = key;
  for (std::size_t dot = path.rfind('.'); dot != std::string::npos; dot = path.rfind('.')) {
    path.resize(dot);
    const auto holder = written_.find(path);
    if (holder != written_.end()) {
      return {holder->second.location, {}};
    }
  }
  return {file_, {}};
}

}  // namespace percolith::case_file
