// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/simd.hpp"
#include "percolith/mesh/corner.hpp"
#include "percolith/seepage/content.hpp"
#include "percolith/seepage/options.hpp"

#include <array>

namespace percolith::seepage {

/// Flow between two corners, (18), (19): `conductance` times the difference of the potential
/// phi = p + rho_w g y, positive into the first; `weight` is the saturation weight of the donor.
template <class Real>
PERCOLITH_DEVICE Real pair_flow(Real conductance, Real potential_difference, Real weight_first,
                                Real weight_second) {
  const Real flow = conductance * potential_difference;
  return flow * select(flow > Real(0.0), weight_second, weight_first);
}

/// Inflow (m2/s) of the three corners of a triangle from each other. Views hold one entry per
/// corner slot. `how` chooses the saturation weight: of the donor, or of the mean of the corners,
/// (17). Where voids cannot be partly empty it is left out: not `weighted`.
struct PoreFlow {
  static constexpr bool vectorised = true;
  const double* pressure;
  const double* saturation;
  const double* conductance;
  const double* lift;  ///< rho_w g y; null without gravity
  double* inflow;
  SaturationWeight how;
  bool weighted;

  template <class Lane>
  PERCOLITH_DEVICE void operator()(Lane lane) const {
    using Real = typename Lane::Real;
    const auto first = mesh::corner_of(lane.first, 0);
    std::array<Real, 3> p;
    std::array<Real, 3> c;
    for (std::size_t k = 0; k < 3; ++k) {
      c[k] = Lane::load(conductance + slot(first, k));
      p[k] = Lane::load(pressure + slot(first, k));
    }
    const std::array<Real, 3> weight = weights<Lane>(first);
    std::array<Real, 3> flow;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      Real difference = p[next] - p[k];
      if (lift != nullptr) {
        // Two differences instead of one sum: a large pressure keeps its digits.
        difference += Lane::load(lift + slot(first, next)) - Lane::load(lift + slot(first, k));
      }
      flow[k] = weighted ? pair_flow(c[k], difference, weight[k], weight[next]) : c[k] * difference;
    }
    Lane::store(inflow + first, flow[0] - flow[2]);
    Lane::store(inflow + first + block_width, flow[1] - flow[0]);
    Lane::store(inflow + first + 2 * block_width, flow[2] - flow[1]);
  }

private:
  PERCOLITH_DEVICE static mesh::Index slot(mesh::Index first, std::size_t k) {
    return first + static_cast<mesh::Index>(k) * block_width;
  }

  template <class Lane>
  PERCOLITH_DEVICE std::array<typename Lane::Real, 3> weights(mesh::Index first) const {
    using Real = typename Lane::Real;
    if (!weighted) {
      return {Real(1.0), Real(1.0), Real(1.0)};
    }
    const std::array<Real, 3> s{Lane::load(saturation + first),
                                Lane::load(saturation + first + block_width),
                                Lane::load(saturation + first + 2 * block_width)};
    if (how == SaturationWeight::mean) {
      const Real weight = saturation_weight((s[0] + s[1] + s[2]) / Real(3.0));
      return {weight, weight, weight};
    }
    return {saturation_weight(s[0]), saturation_weight(s[1]), saturation_weight(s[2])};
  }
};

}  // namespace percolith::seepage
