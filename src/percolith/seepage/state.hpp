// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/archive.hpp"
#include "percolith/seepage/model.hpp"

// What a flow has become since it was built. Whatever follows from the case and the mesh alone is
// left out: it is built anew before a state is read.
namespace percolith::seepage {

/// Everything of a model that steps change.
void describe_state(StateArchive& archive, Model& model);

}  // namespace percolith::seepage
