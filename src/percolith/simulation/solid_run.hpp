// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/execution.hpp"
#include "percolith/mechanics/step_limit.hpp"
#include "percolith/simulation/probe_places.hpp"
#include "percolith/simulation/report.hpp"
#include "percolith/simulation/solid_build.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace percolith::simulation {

/// What is remembered of each joint that broke.
struct BrokenJoints {
  std::vector<std::int32_t> mode;  ///< per joint: 0 broken from the start or not at all, 1, 2, 3
  std::vector<double> time;        ///< s
  std::vector<double> released;    ///< J/m
  std::vector<double> magnitude;   ///< of all events in the order of time
  std::int64_t count = 0;          ///< of joints that broke since time zero
};

/// A rock while it moves, and what reports need of it.
struct SolidRun {
  Setup setup;
  mechanics::Dynamics dynamics;
  Execution execution;
  ProbePlaces probes;
  std::vector<std::string> fracture_names, kind_names;
  std::vector<mechanics::MotionLimit> limits;
  double added_mass = 0.0;  ///< over the mass there was
  BrokenJoints broken;
  mechanics::Fragments fragments;
  bool fragments_stale = true;
  double deepest_overlap = 0.0;  ///< m, since time zero
  Summary summary;
};

/// Fields of the rock and of its broken and softening joints.
[[nodiscard]] MatrixFrame solid_matrix_frame(const SolidRun& run);
/// `joints` and `vertices` get the numbers of the segments and of the points.
[[nodiscard]] CrackFrame solid_crack_frame(const SolidRun& run,
                                           std::vector<mesh::Index>* joints = nullptr,
                                           std::vector<mesh::Index>* vertices = nullptr);
[[nodiscard]] std::vector<ProbeSample> read_solid_probes(const SolidRun& run);

/// The fragments as they are now.
[[nodiscard]] std::vector<FragmentRow> fragment_rows(const SolidRun& run);

/// Energies, reactions and counts of the present state; notes the peaks of the reactions.
[[nodiscard]] HistoryRow solid_history_row(SolidRun& run, double step_size);
/// What the run came to.
[[nodiscard]] Summary solid_summary(const SolidRun& run);
/// Largest share of the work done on the rock, and of the energy it had, that no term of the energy
/// balance accounts for.
[[nodiscard]] double solid_energy_error(const SolidRun& run);
/// Counts, limits and what is worth knowing before the run.
[[nodiscard]] CheckReport solid_check(const SolidRun& run);
[[nodiscard]] std::vector<std::string> solid_warnings(const SolidRun& run);

/// Notes joints that broke and returns them as events; `step` is the number of the step.
[[nodiscard]] std::vector<BreakEvent> note_events(SolidRun& run, const mechanics::Changes& changes,
                                                  std::int64_t step);

/// b-value of magnitudes by maximum likelihood, b = log10(e)/(mean - M_min + dM/2) over those not
/// below M_min, in bins of dM = 0.1, M_min the middle of the fullest bin; not a number with fewer
/// than 20 events.
[[nodiscard]] double b_value(std::span<const double> magnitudes);

/// Step the run takes, s. Throws InputError (key `time.step`) where the step asked for is longer
/// than the stable one.
[[nodiscard]] double solid_step(const SolidRun& run);

}  // namespace percolith::simulation
