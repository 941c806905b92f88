// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/model.hpp"
#include "percolith/simulation/setup.hpp"

#include <string>
#include <vector>

namespace percolith::simulation {

/// Warnings of in-situ stress that is not in balance when a run starts: where it ends at edges of
/// the rock that nothing holds (sigma n = t; whether a load is the right one is not judged), and
/// where its gradient does not carry the weight of the rock (d sigma_yy/dy = rho g). Told of is
/// what matters beside the in-situ stress. Edges that are taken out from the start are left to the
/// excavation, all edges to contact where there are platens. `model` is the rock at time zero.
[[nodiscard]] std::vector<std::string> start_balance_warnings(const Setup& setup,
                                                              const mechanics::Model& model);

}  // namespace percolith::simulation
