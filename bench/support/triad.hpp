// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace percolith::bench {

/// Bytes per second of a = b + s c over three arrays that together hold `bytes`, best of several
/// passes on `threads` threads. Counted as 32 bytes an element: two reads, the write, and the read
/// of the line that is written.
[[nodiscard]] double triad_bandwidth(std::size_t bytes, int threads);

}  // namespace percolith::bench
