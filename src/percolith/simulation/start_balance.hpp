// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/model.hpp"
#include "percolith/simulation/setup.hpp"

#include <string>
#include <vector>

namespace percolith::simulation {

/// Warnings of in-situ stress that is not in balance when a run starts: where it ends at edges of
/// the rock that nothing holds (div sigma = 0 within, sigma n = t at the edges), and where its
/// gradient does not carry the weight of the rock (d sigma_yy/dy = rho g). Told of is what matters
/// beside the largest in-situ stress; edges that touch platens or that are taken out are left to
/// contact and excavation. `model` is the rock at time zero.
[[nodiscard]] std::vector<std::string> start_balance_warnings(const Setup& setup,
                                                              const mechanics::Model& model);

}  // namespace percolith::simulation
