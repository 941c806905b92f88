// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/key_locations.hpp"
#include "percolith/simulation/setup.hpp"

#include <string>
#include <vector>

namespace percolith::case_file {

/// Warnings of values that can be computed with but that no rock has, each with its place in the
/// file: most come from a unit that was not written. They are about stiffness (below 1 MPa),
/// strengths (below 100 Pa but above 0), density (outside of 500 to 10000 kg/m3), permeability
/// (above 1e-6 m2), the angle of layers (beyond a full turn) and Biot's coefficient.
[[nodiscard]] std::vector<std::string> plausibility_warnings(const simulation::Setup& setup,
                                                             const KeyLocations& locations);

}  // namespace percolith::case_file
