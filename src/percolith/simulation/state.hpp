// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/archive.hpp"
#include "percolith/simulation/run.hpp"
#include "percolith/simulation/solid_run.hpp"

// What a run has become since it started, beside its model: what later reports depend on.
namespace percolith::simulation {

/// Counts, the last row of the history and peaks; the rest of a summary is worked out at the end.
void describe_state(StateArchive& archive, Summary& summary);

void describe_state(StateArchive& archive, RunState& run);
void describe_state(StateArchive& archive, SolidRun& run);

}  // namespace percolith::simulation
