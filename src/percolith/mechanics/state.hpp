// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/archive.hpp"
#include "percolith/mechanics/model.hpp"

// What a rock in motion has become since it was built. Whatever follows from the case and the mesh
// alone is left out: it is built anew before a state is read.
namespace percolith::mechanics {

/// Everything of a model that steps change. Both maps of corners follow from the flags of the
/// joints.
void describe_state(StateArchive& archive, Model& model);

}  // namespace percolith::mechanics
