// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/execution.hpp"
#include "percolith/seepage/model.hpp"
#include "percolith/simulation/report.hpp"

#include <optional>

namespace percolith::simulation {

/// Balance of fluid between time zero, when `in_place_at_start` (m2) was there, and now.
[[nodiscard]] MassBalance mass_balance(const seepage::Model& model, double in_place_at_start,
                                       const Execution& execution);
/// Balance of a steady state: `in` and `out` are rates (m2/s), nothing is stored. Water at rest, a
/// throughput not above `round_off` (m2/s), has no relative error.
[[nodiscard]] MassBalance steady_balance(const seepage::Model& model, double round_off,
                                         const Execution& execution);

/// Extremes, balance and rates of the present state.
[[nodiscard]] HistoryRow history_row(const seepage::Model& model, const MassBalance& balance);

/// The place of a pressure or saturation that is not a finite number, for a message; absent when
/// all are.
[[nodiscard]] std::optional<std::string> find_invalid(const seepage::Model& model);

/// The kind and place of a node from which more fluid was taken than it held, for a message;
/// absent when there is none.
[[nodiscard]] std::optional<std::string> find_overdrawn(const seepage::Model& model);

/// Hash of pressures, saturations and contents.
[[nodiscard]] std::string hash_of(const seepage::State& state);

}  // namespace percolith::simulation
