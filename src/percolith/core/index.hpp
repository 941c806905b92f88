// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace percolith {

/// Numbers of triangles, corners, joints and nodes: 32 bits halve what the kernels read.
using Index = std::int32_t;

/// A number as a subscript of the standard containers.
constexpr std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

}  // namespace percolith
