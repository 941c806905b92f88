// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/case.hpp"
#include "percolith/simulation/simulation.hpp"

#include <filesystem>
#include <map>
#include <span>
#include <string>

namespace percolith::cli {

/// A case and the model built from it.
struct LoadedModel {
  case_file::Case read_case;
  simulation::Simulation simulation;
  std::map<std::string, double> wall_time;  ///< s per phase
  std::string mesh_hash;
};

/// Reads the case file, reads or makes its mesh, and builds the model. Throws InputErrors that
/// carry the place in the case file or the mesh file, and FileErrors.
[[nodiscard]] LoadedModel load_model(const std::filesystem::path& case_file,
                                     std::span<const std::string> overrides);

}  // namespace percolith::cli
