// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/key_locations.hpp"
#include "percolith/simulation/setup.hpp"

namespace percolith::case_file {

/// Gives options that the user did not write the defaults that depend on other options, so that
/// resolved.toml shows them.
void choose_defaults(simulation::Setup& setup, const KeyLocations& locations);

}  // namespace percolith::case_file
