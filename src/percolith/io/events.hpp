// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/report.hpp"

#include <string>
#include <vector>

namespace percolith::io {

/// Header line of `events.csv`.
[[nodiscard]] std::string events_header();

/// One line for each joint that broke: time, step, middle of the joint, mode (`tensile`, `shear`,
/// `mixed`), length, energy released per metre of thickness, magnitude, and the table that gave the
/// joint its strengths.
[[nodiscard]] std::string event_lines(const std::vector<simulation::BreakEvent>& events);

}  // namespace percolith::io
