// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/seepage/model.hpp"
#include "percolith/simulation/report.hpp"
#include "percolith/simulation/setup.hpp"

namespace percolith::simulation {

/// Counts, mesh quality and limits of the explicit step; adds to `warnings`, those known already.
[[nodiscard]] CheckReport make_check_report(const Setup& setup, const seepage::Model& model,
                                            std::vector<std::string> warnings);

/// What deserves a word although it can be computed.
[[nodiscard]] std::vector<std::string> model_warnings(const Setup& setup,
                                                      const seepage::Model& model);

}  // namespace percolith::simulation
