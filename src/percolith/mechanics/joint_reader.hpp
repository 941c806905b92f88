// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/joint.hpp"
#include "percolith/mechanics/model.hpp"

namespace percolith::mechanics {

/// Constants of the law per kind of joint, as the kernels read them.
using JointTable = std::vector<material::JointConstants<double>>;
/// One entry for each of `Model::kind`, stiffness 0: that is a property of each joint. A strength
/// of zero gets a range of softening of next to nothing.
[[nodiscard]] JointTable joint_table(const Model& model);

/// Opening and slip of a joint at its two integration points, m, in-situ start included.
template <class Real>
struct OpeningAndSlip {
  std::array<Real, 2> opening, slip;
};

/// Reads joints in the lanes of a kernel: how they lie, what their bonds are made of
/// and what they remember. Views
/// into the model, which must outlive it.
class JointReader {
public:
  /// Of joints at the displacements `ux` and `uy` (m), an entry a corner slot.
  JointReader(const Model& model, const JointTable& table, const double* ux, const double* uy);

  /// Undeformed length, m.
  template <class Lane>
  [[nodiscard]] PERCOLITH_DEVICE typename Lane::Real length(Index j) const {
    return Lane::load(length_ + j);
  }

  template <class Lane>
  [[nodiscard]] PERCOLITH_DEVICE JointPlace<typename Lane::Real> place(Index j) const {
    std::array<std::array<Vec2<typename Lane::Real>, 2>, 2> u;
    const Index* corner = slot_ + force_slot(j);
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t end = 0; end < 2; ++end) {
        u[side][end] = {Lane::gather(ux_, corner), Lane::gather(uy_, corner)};
        corner += block_width;
      }
    }
    return joint_place({Lane::load(ex_ + j), Lane::load(ey_ + j)}, u);
  }

  template <class Lane>
  [[nodiscard]] PERCOLITH_DEVICE OpeningAndSlip<typename Lane::Real>
  opening_and_slip(Index j, const JointPlace<typename Lane::Real>& place) const {
    using Real = typename Lane::Real;
    OpeningAndSlip<Real> now;
    for (std::size_t g = 0; g < 2; ++g) {
      const Vec2<Real> apart = apart_at(place, g);
      now.opening[g] = dot(apart, place.across);
      now.slip[g] = dot(apart, place.along);
      if (starts_) {
        now.opening[g] += Lane::load(opening_start_[g] + j);
        now.slip[g] += Lane::load(slip_start_[g] + j);
      }
    }
    return now;
  }

  template <class Lane>
  [[nodiscard]] PERCOLITH_DEVICE material::JointConstants<typename Lane::Real>
  constants(Index j) const {
    using Real = typename Lane::Real;
    material::JointConstants<Real> c{};
    if (uniform_[j / block_width] != 0) {
      const material::JointConstants<double>& one = table_[strength_[j]];
      c = {Real(0.0),          Real(one.tensile),       Real(one.cohesion),
           Real(one.friction), Real(one.opening_range), Real(one.slip_range)};
    } else {
      const auto pick = [&](double material::JointConstants<double>::*member) {
        return Lane::generate([&](Index i) { return table_[strength_[j + i]].*member; });
      };
      using Constants = material::JointConstants<double>;
      c = {Real(0.0),
           pick(&Constants::tensile),
           pick(&Constants::cohesion),
           pick(&Constants::friction),
           pick(&Constants::opening_range),
           pick(&Constants::slip_range)};
    }
    c.stiffness = Lane::load(stiffness_ + j);
    if (factor_ != nullptr) {
      // Weaker joints spend less energy: the opening and slip over which they soften stay the same.
      const Real f = Lane::load(factor_ + j);
      c.tensile = c.tensile * f;
      c.cohesion = c.cohesion * f;
    }
    return c;
  }

  /// What bonds remember at integration point `g`.
  template <class Lane>
  [[nodiscard]] PERCOLITH_DEVICE material::JointMemory<typename Lane::Real>
  memory(Index j, std::size_t g) const {
    return {Lane::load(opening_peak_[g] + j),  Lane::load(slip_peak_[g] + j),
            Lane::load(damage_[g] + j),        Lane::load(past_slope_[g] + j),
            Lane::load(past_friction_[g] + j), Lane::load(past_slip_[g] + j)};
  }

private:
  const double* ux_;
  const double* uy_;
  const Index* slot_;
  const double* ex_;
  const double* ey_;
  const double* length_;
  const double* stiffness_;
  const Index* strength_;
  const std::uint8_t* uniform_;
  const material::JointConstants<double>* table_;
  const double* factor_;
  bool starts_;
  std::array<const double*, 2> opening_start_, slip_start_;
  std::array<const double*, 2> opening_peak_, slip_peak_, damage_;
  std::array<const double*, 2> past_slope_, past_friction_, past_slip_;
};

}  // namespace percolith::mechanics
