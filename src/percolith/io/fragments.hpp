// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/report.hpp"

#include <string>
#include <vector>

namespace percolith::io {

/// Header line of `fragments.csv`.
[[nodiscard]] std::string fragments_header();

/// One line for each fragment at a time (s): number, triangles, undeformed area, present centre and
/// mean velocity.
[[nodiscard]] std::string fragment_lines(double time,
                                         const std::vector<simulation::FragmentRow>& rows);

}  // namespace percolith::io
