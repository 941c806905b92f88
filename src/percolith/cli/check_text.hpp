// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/report.hpp"
#include "percolith/simulation/setup.hpp"

#include <string>

namespace percolith::cli {

/// What `percolith check` prints about a model: counts, mesh quality, the named numbers of
/// mechanics, and the limits of the explicit time step, smallest first, with the one that rules.
/// Warnings are not in it.
[[nodiscard]] std::string check_text(const simulation::CheckReport& report,
                                     const simulation::Stepping& stepping);

}  // namespace percolith::cli
