// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/report.hpp"

#include <string>

namespace percolith::io {

/// Header line of `probes/<name>.csv`: time_s, x_m, y_m and the columns of `sample`.
[[nodiscard]] std::string probe_header(const simulation::ProbeSample& sample);

/// The rows of `sample` at `time` (s), one line a point; the cell of what is not a number stays
/// empty. Throws std::invalid_argument where a row has not one value a column.
[[nodiscard]] std::string probe_lines(double time, const simulation::ProbeSample& sample);

}  // namespace percolith::io
