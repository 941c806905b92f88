// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/coupling/pressure_rise.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace percolith::coupling {

PressureRise::PressureRise(const seepage::Model& water)
    : pores_(water.state.pressure), cracks_(water.state.crack_pressure),
      full_(water.cracks.open_nodes()) {
  std::erase_if(full_, [&](Index v) { return water.state.crack_saturation[at(v)] < 1.0; });
}

void PressureRise::see(const seepage::Model& water) {
  double difference = 0.0;
  double scale = 1e-300;
  const auto compare = [&](double start, double now) {
    difference = std::max(difference, std::abs(now - start));
    scale = std::max(scale, std::abs(now));
  };
  for (std::size_t i = 0; i < pores_.size(); ++i) {
    compare(pores_[i], water.state.pressure[i]);
  }
  for (const Index v : full_) {
    compare(cracks_[at(v)], water.state.crack_pressure[at(v)]);
  }
  largest_ = std::max(largest_, difference / scale);
}

}  // namespace percolith::coupling
