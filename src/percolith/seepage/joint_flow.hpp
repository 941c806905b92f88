// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/seepage/model.hpp"
#include "percolith/seepage/pore_flow.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace percolith::seepage {

/// Finite joints as their triangles see them: entry `corner` belongs to the edge that starts there
/// (local k to k + 1). Edges without a finite joint have no conductance and face themselves.
struct JointsAcross {
  std::vector<double> conductance;  ///< 1/2 h_j L, m2/(Pa s)
  std::vector<Index> start;         ///< corner on the other side at the start of the edge
  std::vector<Index> end;           ///< and at its end
};

/// Looks up every finite joint of the model from both sides.
[[nodiscard]] JointsAcross joints_across(const Model& model);
/// Takes out a joint that has broken.
void close_joint(const Model& model, Index joint, JointsAcross& across);

/// Adds to the inflow (m2/s) of the corners of a triangle what crosses its finite joints,
/// (20)-(22). Both sides compute the flow with the same operations on swapped operands, so the two
/// results differ in sign only and no fluid is lost, and no flow has to be kept per joint.
struct JointFlow {
  static constexpr bool vectorised = true;
  const double* pressure;
  const double* saturation;
  const double* conductance;
  const Index* start;
  const Index* end;
  double* inflow;
  Index corners;  ///< slots
  bool weighted;  ///< voids may be partly empty

  template <class Lane>
  PERCOLITH_DEVICE void operator()(Lane lane) const {
    using Real = typename Lane::Real;
    std::array<Index, 3> slot;
    std::array<Real, 3> sum;
    for (std::size_t k = 0; k < 3; ++k) {
      slot[k] = mesh::corner_of(lane.first, static_cast<Index>(k));
      const Index ahead = std::min(slot[k] + prefetch_distance, corners - 1);
      prefetch(pressure + ahead);
      prefetch(saturation + ahead);
      sum[k] = Lane::load(inflow + slot[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const Real c = Lane::load(conductance + slot[k]);
      sum[k] += flow<Lane>(c, slot[k], start + slot[k]);
      sum[next] += flow<Lane>(c, slot[next], end + slot[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      Lane::store(inflow + slot[k], sum[k]);
    }
  }

private:
  /// Flow into the corners at `here` from those at `*there`.
  template <class Lane>
  PERCOLITH_DEVICE typename Lane::Real flow(typename Lane::Real c, Index here,
                                            const Index* there) const {
    using Real = typename Lane::Real;
    const Real difference = Lane::gather(pressure, there) - Lane::load(pressure + here);
    if (!weighted) {
      return c * difference;
    }
    const Real mine = saturation_weight(Lane::load(saturation + here));
    const Real other = saturation_weight(Lane::gather(saturation, there));
    return pair_flow(c, difference, mine, other);
  }
};

}  // namespace percolith::seepage
