// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/seepage/model.hpp"
#include "percolith/simulation/frames.hpp"
#include "percolith/simulation/solid_run.hpp"

#include <map>
#include <string>
#include <vector>

namespace percolith::simulation {

/// The fluid of a coupled run, and what reports need of it.
struct WaterRun {
  seepage::Model model;
  ProbeReader probes;
  double in_place_at_start = 0.0;               ///< m2
  std::map<std::string, mesh::Index> drainage;  ///< condition of each excavation
};

/// The fields of both halves: points are corners or nodes that move together and share a pressure.
[[nodiscard]] MatrixFrame coupled_matrix_frame(const SolidRun& rock, const WaterRun& water);
/// Broken and softening joints; those that fluid has not entered are dry (`wet` 0).
[[nodiscard]] CrackFrame coupled_crack_frame(const SolidRun& rock, const WaterRun& water);
/// Values of the flow and of the motion side by side; probes in cracks tell those of the flow.
[[nodiscard]] std::vector<ProbeSample> read_coupled_probes(const SolidRun& rock,
                                                           const WaterRun& water);

/// The rows of both halves in one, with length (m), volume (m2) and mean aperture (m) of the
/// cracks, the fluid in them and what has leaked out of them into the rock (m2), and the pressure
/// at each source in a crack (Pa), whose peak is noted. `leaked` as `coupling::Scheme` counts it.
[[nodiscard]] HistoryRow coupled_history_row(SolidRun& rock, const WaterRun& water, double leaked,
                                             double step_size);

/// Fluid in the cracks, m2.
[[nodiscard]] double crack_fluid(const seepage::Model& model);

}  // namespace percolith::simulation
