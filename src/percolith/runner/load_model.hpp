// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/case.hpp"
#include "percolith/simulation/simulation.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace percolith::runner {

/// A case and the model built from it.
struct LoadedModel {
  case_file::Case read_case;
  simulation::Simulation simulation;
  std::map<std::string, double> wall_time;  ///< s per phase
  std::string mesh_hash;
};

/// Where a case comes from.
struct CaseSource {
  std::filesystem::path file;            ///< as messages name it; files it names are relative to it
  std::optional<std::string> text;       ///< absent: what the file holds
  std::vector<std::string> overrides{};  ///< `path.to.key=value`
};

/// Reads and checks the case alone. Throws as `case_file::read_case` does.
[[nodiscard]] case_file::Case read_case(const CaseSource& source);

/// Reads the case, reads or makes its mesh, and builds the model. Throws InputErrors that carry the
/// place in the case file or the mesh file, and FileErrors.
[[nodiscard]] LoadedModel load_model(const CaseSource& source,
                                     const simulation::StartingMotion& start = {});

}  // namespace percolith::runner
