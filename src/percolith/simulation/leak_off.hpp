// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/seepage/model.hpp"
#include "percolith/simulation/setup.hpp"

#include <string>
#include <vector>

namespace percolith::simulation {

/// Warnings of fluid that, by the end of the run, has come less far into the rock than one element
/// reaches, so that how much leaks off follows from the mesh or from the exchange coefficient and
/// not from the permeability. It comes as far as l = sqrt(k t/(mu S)), with S = 1/M of a rock at
/// rest and 1/M + alpha^2/E_oed of one that deforms, E_oed = E (1 - nu)/((1 + nu)(1 - 2 nu))
/// (docs/choosing.md). One warning for each fracture that conditions feed and whose walls are no
/// slower than the rock (h_c mu l/k >= 1), each source in the matrix and, in coupled physics, each
/// pressurised boundary. None in steady flow.
[[nodiscard]] std::vector<std::string> leak_off_warnings(const Setup& setup,
                                                         const seepage::Model& model);

}  // namespace percolith::simulation
