// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/seepage/model.hpp"

#include <map>
#include <string>

namespace percolith::bench {

/// Bytes each phase of an explicit step has to move between memory and processor when caches serve
/// every reuse within a phase and nothing from one phase to the next: each cache line a phase
/// touches counts once when it is read and twice when it is written, for a line is read before it
/// is written back. Full nodes stay full.
[[nodiscard]] std::map<std::string, double> step_traffic(const seepage::Model& model);

/// Bytes of the arrays an explicit step works on: what a triad must be as large as to meet the same
/// caches.
[[nodiscard]] std::size_t step_footprint(const seepage::Model& model);

}  // namespace percolith::bench
