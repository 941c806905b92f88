// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/execution.hpp"
#include "percolith/mechanics/joint_forces.hpp"

namespace percolith::mechanics {

/// Pore pressure that acts between the faces of bonded joints besides their effective traction,
/// -alpha p n (theory.md section 18): p at an integration point is interpolated between the ends,
/// where it is the mean of both sides.
struct PoresInJoints {
  const double* pressure;  ///< per corner, Pa
  const double* share;     ///< per joint: alpha, or 0
  const Index* slot;       ///< `Joints::slot`
  std::array<double*, 2> push, opening;

  /// Work on the faces since the last step, J/m: that of the mean pressure of both moments.
  template <class Lane>
  PERCOLITH_DEVICE typename Lane::Real
  press(Index j, typename Lane::Real length, const std::array<typename Lane::Real, 2>& now,
        std::array<material::JointTraction<typename Lane::Real>, 2>& t) const {
    using Real = typename Lane::Real;
    std::array<Real, 2> at_end;
    const Index* corner = slot + force_slot(j);
    for (std::size_t end = 0; end < 2; ++end) {
      const Index* here = corner + static_cast<Index>(end) * block_width;
      at_end[end] = Real(0.5) *
                    (Lane::gather(pressure, here) + Lane::gather(pressure, here + 2 * block_width));
    }
    const Real alpha = Lane::load(share + j);
    Real work(0.0);
    for (std::size_t g = 0; g < 2; ++g) {
      const Real p =
          alpha * (Real(gauss_weight(g)) * at_end[0] + Real(gauss_weight(1 - g)) * at_end[1]);
      t[g].normal = t[g].normal - p;
      work += (Lane::load(push[g] + j) + p) * (now[g] - Lane::load(opening[g] + j));
      Lane::store(push[g] + j, p);
      Lane::store(opening[g] + j, now[g]);
    }
    return Real(0.25) * length * work;
  }
};

/// Forces of bonded joints with pore pressure in them; the one sum is the work of that pressure,
/// J/m.
struct WetJointForces {
  static constexpr bool vectorised = true;

  WetJointForces(Model& model, const JointTable& table);

  template <class Lane>
  PERCOLITH_DEVICE void operator()(Lane lane, LaneSums<1>& sums) const {
    joints_.act<Lane>(lane.first, Booked<Lane>{&pores_, lane, &sums});
  }

private:
  template <class Lane>
  struct Booked {
    const PoresInJoints* pores;
    Lane lane;
    LaneSums<1>* sums;
    template <class L>
    PERCOLITH_DEVICE void add(Index j, typename L::Real length,
                              const std::array<typename L::Real, 2>& opening,
                              std::array<material::JointTraction<typename L::Real>, 2>& t) const {
      sums->add(0, lane, pores->template press<L>(j, length, opening, t));
    }
  };
  JointForces joints_;
  PoresInJoints pores_;
};

/// Share of the pore pressure that acts between the faces of a bonded joint now, at its integration
/// points, Pa; 0 in other joints.
[[nodiscard]] std::array<double, 2> push_in_joint(const Model& model, Index joint);

/// Books the work of the last pore pressure in bonded joints up to the present places: the next
/// one acts from here on.
void book_pores(Model& model);

/// Takes the pore pressure out of a joint and books the work of its last force: from now on its
/// faces are pressed by a crack, or part.
void leave_pores(Model& model, Index joint);

}  // namespace percolith::mechanics
