// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace percolith::coupling {

/// What a step that takes long is at.
struct Doing {
  const char* what = "";   ///< for a reader
  double time = 0.0;       ///< s: what lies before is solved
  std::int64_t broke = 0;  ///< joints that broke in the step
};

}  // namespace percolith::coupling
