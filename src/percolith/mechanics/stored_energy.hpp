// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/joint_forces.hpp"
#include "percolith/mechanics/solid_forces.hpp"

#include <vector>

namespace percolith::mechanics {

/// Displacements of all corners at one moment, m, an entry a corner slot.
struct Displacements {
  std::vector<double> ux, uy;
};

/// Where the corners were `back` (s) ago, at their present velocities.
[[nodiscard]] Displacements displacements_before(const Model& model, double back);

/// Adds up what triangles are strained, J/m: A (E.D.E/2 + S_0.E) of those that are there.
class StrainEnergy {
public:
  static constexpr bool vectorised = true;

  StrainEnergy(const Model& model, const Displacements& u)
      : solid_(model), ux_(u.ux.data()), uy_(u.uy.data()),
        inverse_mass_(model.triangles.inverse_mass.data()) {}

  template <class Lane>
  PERCOLITH_DEVICE void operator()(Lane lane, LaneSums<1>& sums) const {
    using Real = typename Lane::Real;
    const auto u = load_corners<Lane>(ux_, uy_, mesh::corner_of(lane.first, 0));
    const auto is_there = Lane::load(inverse_mass_ + lane.first) > Real(0.0);
    sums.add(0, lane, select(is_there, solid_.strain_energy<Lane>(lane.first, u), Real(0.0)));
  }

private:
  SolidForces solid_;
  const double* ux_;
  const double* uy_;
  const double* inverse_mass_;
};

/// What the joints hold, in the order of the sums of `BondEnergy`.
enum class BondTerm : std::size_t {
  stored,  ///< what bonds give back when they are unloaded along their secants, J/m
  fluid,   ///< work of the pore pressure in them since the last step, J/m
  count
};
inline constexpr auto bond_terms = static_cast<std::size_t>(BondTerm::count);

/// Adds up what bonded joints hold with their memory as it stands.
class BondEnergy {
public:
  static constexpr bool vectorised = true;

  BondEnergy(const Model& model, const JointTable& table, const Displacements& u);

  template <class Lane>
  PERCOLITH_DEVICE void operator()(Lane lane, LaneSums<bond_terms>& sums) const {
    using Real = typename Lane::Real;
    const Index j = lane.first;
    const std::uint8_t block = condition_[j / block_width];
    if (block == static_cast<std::uint8_t>(BlockCondition::gone)) {
      return;
    }
    const auto c = reader_.constants<Lane>(j);
    const auto now = reader_.opening_and_slip<Lane>(j, reader_.place<Lane>(j));
    auto weak = Real(0.0) > Real(0.0);
    Real stored(0.0);
    for (std::size_t g = 0; g < 2; ++g) {
      const auto t = material::elastic_traction(c.stiffness, now.opening[g], now.slip[g]);
      weak = weak || material::exceeds_strength(c, t);
      stored += Real(0.5) * (t.normal * now.opening[g] + t.shear * now.slip[g]);
    }
    if (block != static_cast<std::uint8_t>(BlockCondition::whole) || any(weak)) {
      stored = softened<Lane>(j, c, now);
    }
    const Real half = Real(0.5) * reader_.length<Lane>(j);
    const auto bonded = c.stiffness > Real(0.0);
    sums.add(static_cast<std::size_t>(BondTerm::stored), lane,
             half * select(bonded, stored, Real(0.0)));
    if (push_[0] != nullptr) {
      Real work(0.0);
      for (std::size_t g = 0; g < 2; ++g) {
        work += Lane::load(push_[g] + j) * (now.opening[g] - Lane::load(opening_[g] + j));
      }
      sums.add(static_cast<std::size_t>(BondTerm::fluid), lane, half * work);
    }
  }

private:
  template <class Lane>
  PERCOLITH_DEVICE typename Lane::Real
  softened(Index j, const material::JointConstants<typename Lane::Real>& c,
           const OpeningAndSlip<typename Lane::Real>& now) const {
    using Real = typename Lane::Real;
    Real stored(0.0);
    for (std::size_t g = 0; g < 2; ++g) {
      material::JointMemory<Real> memory = reader_.memory<Lane>(j, g);
      const auto t = material::softening_traction(c, now.opening[g], now.slip[g], memory);
      stored += material::stored_energy(
          c, material::moment_of(c, now.opening[g], now.slip[g], t, memory));
    }
    return stored;
  }

  JointReader reader_;
  std::array<const double*, 2> push_{}, opening_{};  // null where joints have no pores
  const std::uint8_t* condition_;
};

}  // namespace percolith::mechanics
