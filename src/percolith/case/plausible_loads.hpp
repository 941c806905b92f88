// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/doubts.hpp"
#include "percolith/simulation/setup.hpp"

namespace percolith::case_file {

/// Doubts of what presses on rock that moves: loads and in-situ stresses below 100 Pa but not 0,
/// in-situ stresses whose sign is that of tension or that no boundary holds, and fluid that is kept
/// out of softening joints which in-situ stress presses together.
void judge_loads(const simulation::Setup& setup, Doubts& doubts);

}  // namespace percolith::case_file
