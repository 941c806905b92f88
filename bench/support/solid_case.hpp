// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/dynamics.hpp"

#include <cstdint>

namespace percolith::bench {

/// A square metre of rock with joints on every edge, thrown about by waves and gravity.
struct SolidCase {
  bool broken = false;  ///< every joint is broken and every triangle pressed into its neighbours
};

/// The rock, ready to move, and a stable step for it.
struct SolidBench {
  mechanics::Dynamics dynamics;
  double dt = 0.0;  ///< s
};
[[nodiscard]] SolidBench make_solid(std::int32_t triangles, const SolidCase& what);

/// Bytes a step of intact rock moves at least from and to memory, per phase, when every array is
/// read or written once: the joints, and the triangles with their motion.
struct SolidTraffic {
  double joints = 0.0, triangles = 0.0;
};
[[nodiscard]] SolidTraffic solid_traffic(const mechanics::Model& model);

}  // namespace percolith::bench
