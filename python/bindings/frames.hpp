// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/report.hpp"

#include <nanobind/nanobind.h>

namespace percolith::python {

/// The matrix and the cracks of a frame as two dictionaries of `points` (n, 2), `cells`, and
/// `point_data` and `cell_data`, dictionaries of arrays under the names that files have. The arrays
/// are those of the frame, which they keep.
[[nodiscard]] nanobind::tuple frame_arrays(simulation::Frame frame);

}  // namespace percolith::python
