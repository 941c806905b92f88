// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/key_locations.hpp"
#include "percolith/simulation/setup.hpp"

#include <string>
#include <vector>

namespace percolith::case_file {

/// Warnings of values that can be computed with but that no rock has, each with its place in the
/// file: most come from a unit that was not written. They are about stiffness (below 1 MPa),
/// strengths (below 100 Pa but above 0), fracture energies (above 1e5 J/m2), density (outside of
/// 500 to 10000 kg/m3), permeability (above 1e-7 m2), apertures (above 20 mm), rates of
/// sources (above 1 m2/s), intervals of output beyond the end of the run, the angle of layers
/// (beyond a full turn), Biot's coefficient, loads and in-situ stresses (below 100 Pa but not 0),
/// the signs of in-situ stress and what holds it at the edges, and fluid that is kept out of
/// softening joints which in-situ stress presses together.
[[nodiscard]] std::vector<std::string> plausibility_warnings(const simulation::Setup& setup,
                                                             const KeyLocations& locations);

}  // namespace percolith::case_file
