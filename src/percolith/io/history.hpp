// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/report.hpp"

#include <string>

namespace percolith::io {

/// Header line of `history.csv` for rows like `row`: time_s, step, step_size_s and the columns of
/// flow, where each condition adds `<option path>_m2_per_s`; in a run of mechanics its names take
/// the place of those of flow.
[[nodiscard]] std::string history_header(const simulation::HistoryRow& row);

/// `row` as a line of `history.csv`: time, step, extremes, volumes since time zero (m2: m3 per
/// metre of thickness) and the current rate of each condition, or the values of mechanics. Cells
/// on the flow in cracks stay empty while there are none.
[[nodiscard]] std::string history_line(const simulation::HistoryRow& row);

}  // namespace percolith::io
