// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/joint_reader.hpp"

namespace percolith::mechanics {

/// What adds nothing to the traction of a joint.
struct NothingInJoints {
  template <class Lane>
  PERCOLITH_DEVICE void add(Index, typename Lane::Real, const std::array<typename Lane::Real, 2>&,
                            std::array<material::JointTraction<typename Lane::Real>, 2>&) const {}
};

/// Forces of the bonded joints. A block none of whose joints was ever past its peak is `whole` and
/// has no memory to read; the first one past it makes the block `damaged`.
struct JointForces {
  static constexpr bool vectorised = true;

  /// Views into the model, which must outlive the kernel; forces, memory and past are written.
  explicit JointForces(Model& model, const JointTable& table);

  template <class Lane>
  PERCOLITH_DEVICE void operator()(Lane lane) const {
    act<Lane>(lane.first, NothingInJoints{});
  }

  /// The same; `inside.add(joints, length, opening, traction)` adds to the traction of the bonds
  /// what else acts between the faces, at the two integration points.
  template <class Lane, class Inside>
  PERCOLITH_DEVICE void act(Index j, const Inside& inside) const {
    using Real = typename Lane::Real;
    std::uint8_t& block = condition_[j / block_width];
    if (block == static_cast<std::uint8_t>(BlockCondition::gone)) {
      return;
    }
    const JointPlace<Real> place = reader_.place<Lane>(j);
    const material::JointConstants<Real> c = reader_.constants<Lane>(j);
    const OpeningAndSlip<Real> now = reader_.opening_and_slip<Lane>(j, place);
    std::array<material::JointTraction<Real>, 2> t;
    auto weak = Real(0.0) > Real(0.0);
    for (std::size_t g = 0; g < 2; ++g) {
      t[g] = material::elastic_traction(c.stiffness, now.opening[g], now.slip[g]);
      weak = weak || material::exceeds_strength(c, t[g]);
    }
    const Real length = reader_.length<Lane>(j);
    if (block != static_cast<std::uint8_t>(BlockCondition::whole) || any(weak)) {
      soften<Lane>(j, c, length, now, t, block);
    }
    inside.template add<Lane>(j, length, now.opening, t);
    const auto f = joint_forces(place, length, t);
    double* out = force_ + force_slot(j);
    Lane::store(out, f[0].x);
    Lane::store(out + block_width, f[0].y);
    Lane::store(out + 2 * block_width, f[1].x);
    Lane::store(out + 3 * block_width, f[1].y);
  }

private:
  /// Opening over the length of a joint, at a point that has failed, at which all of it does.
  static constexpr double gaping_share = 0.1;

  template <class Lane>
  PERCOLITH_DEVICE void soften(Index j, const material::JointConstants<typename Lane::Real>& c,
                               typename Lane::Real length,
                               const OpeningAndSlip<typename Lane::Real>& place,
                               std::array<material::JointTraction<typename Lane::Real>, 2>& t,
                               std::uint8_t& block) const {
    using Real = typename Lane::Real;
    Real least(1.0);
    Real gap(0.0);  // opening of a point that has failed
    Real spent(0.0);
    Real rubbed(0.0);
    const auto bonded = c.stiffness > Real(0.0);
    for (std::size_t g = 0; g < 2; ++g) {
      material::JointMemory<Real> memory = reader_.memory<Lane>(j, g);
      const Real opening = place.opening[g];
      const Real slip = place.slip[g];
      const Real damage_before = memory.damage;
      t[g] = material::softening_traction(c, opening, slip, memory);
      const auto now = material::moment_of(c, opening, slip, t[g], memory);
      const material::JointLoss<Real> lost =
          material::joint_loss(c, exchange_moment<Lane>(j, g, damage_before, now), now);
      spent += select(bonded, lost.bond, Real(0.0));
      rubbed += select(bonded, lost.friction, Real(0.0));
      Lane::store(opening_peak_[g] + j, memory.opening_peak);
      Lane::store(slip_peak_[g] + j, memory.slip_peak);
      Lane::store(damage_[g] + j, memory.damage);
      least = smaller(least, memory.damage);
      gap = larger(gap, select(memory.damage >= Real(1.0), opening, Real(0.0)));
    }
    // Faces that gape hang on one point like on a hinge, and the law is not made for what turns.
    const auto gapes = gap > Real(gaping_share) * length;
    least = select(gapes, Real(1.0), least);
    for (double* damage : damage_) {
      Lane::store(damage + j, select(gapes, Real(1.0), Lane::load(damage + j)));
    }
    const Real half = Real(0.5) * length;
    Lane::store(spent_ + j, Lane::load(spent_ + j) + half * spent);
    Lane::store(rubbed_ + j, Lane::load(rubbed_ + j) + half * rubbed);
    const auto reached = any(least >= Real(1.0)) ? BlockCondition::failed : BlockCondition::damaged;
    // Eight lanes of one block may come one after the other: none takes back what another found.
    if (block < static_cast<std::uint8_t>(reached)) {
      block = static_cast<std::uint8_t>(reached);
    }
  }

  /// A point as it was in the last step, and now in its place.
  template <class Lane>
  PERCOLITH_DEVICE material::JointMoment<typename Lane::Real>
  exchange_moment(Index j, std::size_t g, typename Lane::Real damage_before,
                  const material::JointMoment<typename Lane::Real>& now) const {
    const material::JointMoment<typename Lane::Real> before{
        Lane::load(past_opening_[g] + j),
        Lane::load(past_slip_[g] + j),
        {Lane::load(past_normal_[g] + j), Lane::load(past_shear_[g] + j)},
        Lane::load(past_slope_[g] + j),
        Lane::load(past_friction_[g] + j),
        damage_before};
    Lane::store(past_opening_[g] + j, now.opening);
    Lane::store(past_slip_[g] + j, now.slip);
    Lane::store(past_normal_[g] + j, now.traction.normal);
    Lane::store(past_shear_[g] + j, now.traction.shear);
    // Whole points have no memory, whether a neighbour in their block is damaged or not.
    Lane::store(past_slope_[g] + j,
                select(now.damage > typename Lane::Real(0.0), now.slope, typename Lane::Real(0.0)));
    Lane::store(past_friction_[g] + j, now.friction);
    return before;
  }

  JointReader reader_;
  std::array<double*, 2> opening_peak_, slip_peak_, damage_;
  std::array<double*, 2> past_opening_, past_slip_, past_normal_, past_shear_, past_slope_,
      past_friction_;
  double* spent_;
  double* rubbed_;
  std::uint8_t* condition_;
  double* force_;
};

}  // namespace percolith::mechanics
