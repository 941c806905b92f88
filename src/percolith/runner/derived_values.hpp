// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/documents.hpp"
#include "percolith/simulation/report.hpp"

#include <string>
#include <vector>

namespace percolith::runner {

/// What the program worked out of a case, for the comments of its resolved copy: counts, sizes,
/// limits of the explicit step; of flow the nodes, of mechanics its named numbers.
[[nodiscard]] std::vector<case_file::DerivedValue>
derived_values(const simulation::CheckReport& report, const std::string& version);

}  // namespace percolith::runner
