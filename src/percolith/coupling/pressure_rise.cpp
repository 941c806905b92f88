// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/coupling/pressure_rise.hpp"

#include <algorithm>
#include <cmath>

namespace percolith::coupling {

PressureRise::PressureRise(const seepage::Model& water)
    : pores_(water.state.pressure), cracks_(water.state.crack_pressure) {
  for (const double p : pores_) {
    highest_ = std::max(highest_, p);
  }
  for (const Index v : water.cracks.open_nodes()) {
    highest_ = std::max(highest_, cracks_[at(v)]);
    (water.state.crack_saturation[at(v)] < 1.0 ? filling_ : full_).push_back(v);
  }
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
  for (const Index v : filling_) {
    const double now = water.state.crack_pressure[at(v)];
    compare(std::min(now, highest_), now);
  }
  largest_ = std::max(largest_, difference / scale);
}

}  // namespace percolith::coupling
