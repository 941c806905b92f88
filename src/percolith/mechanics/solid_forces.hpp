// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/model.hpp"
#include "percolith/mechanics/triangle.hpp"

namespace percolith::mechanics {

/// Vectors at the three corners of a triangle.
template <class Real>
using CornerVectors = std::array<Vec2<Real>, 3>;

/// Loads x and y at the three corners of the lane's triangles; views have an entry a corner slot.
template <class Lane>
PERCOLITH_DEVICE CornerVectors<typename Lane::Real> load_corners(const double* x, const double* y,
                                                                 Index first) {
  const auto corner = [&](Index k) {
    const Index slot = first + k * block_width;
    return Vec2<typename Lane::Real>{Lane::load(x + slot), Lane::load(y + slot)};
  };
  return {corner(0), corner(1), corner(2)};
}

template <class Lane>
PERCOLITH_DEVICE void store_corners(const CornerVectors<typename Lane::Real>& v, double* x,
                                    double* y, Index first) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Index slot = first + static_cast<Index>(k) * block_width;
    Lane::store(x + slot, v[k].x);
    Lane::store(y + slot, v[k].y);
  }
}

/// What a triangle makes of its own motion and gathers from the joints at its edges: the internal
/// forces of its corners.
struct SolidForces {
  explicit SolidForces(const Model& model);
  [[nodiscard]] PERCOLITH_DEVICE bool is_viscous() const { return viscosity_ != nullptr; }
  [[nodiscard]] PERCOLITH_DEVICE bool is_wet() const { return pore_pressure_ != nullptr; }

  /// Forces of the stress, viscous stress included; `viscous` gets the forces of the viscous part
  /// and is left alone where nothing is viscous.
  template <class Lane>
  PERCOLITH_DEVICE CornerVectors<typename Lane::Real>
  of_stress(Index t, const CornerVectors<typename Lane::Real>& u,
            const CornerVectors<typename Lane::Real>& v,
            CornerVectors<typename Lane::Real>& viscous) const {
    using Real = typename Lane::Real;
    const TriangleShape<Real> shape = shape_of<Lane>(t);
    const Gradient<Real> h = gradient_of(shape, u[1] - u[0], u[2] - u[0]);
    SymmetricTensor2<Real> stress = material::stress_of(stiffness<Lane>(t), green_strain(h));
    if (initial_xx_ != nullptr) {
      stress.xx += Lane::load(initial_xx_ + t);
      stress.yy += Lane::load(initial_yy_ + t);
      stress.xy += Lane::load(initial_xy_ + t);
    }
    if (viscosity_ != nullptr) {
      const Gradient<Real> rate = gradient_of(shape, v[1] - v[0], v[2] - v[0]);
      const SymmetricTensor2<Real> d = green_strain_rate(h, rate);
      const Real twice = Real(2.0) * Lane::load(viscosity_ + t);
      const SymmetricTensor2<Real> drag{twice * d.xx, twice * d.yy, twice * d.xy};
      viscous = corner_forces(shape, h, drag);
      stress.xx += drag.xx;
      stress.yy += drag.yy;
      stress.xy += drag.xy;
    }
    return corner_forces(shape, h, stress);
  }

  /// Energy of the triangles strained from their in-situ stress, J/m: A (E.D.E/2 + S_0.E).
  template <class Lane>
  [[nodiscard]] PERCOLITH_DEVICE typename Lane::Real
  strain_energy(Index t, const CornerVectors<typename Lane::Real>& u) const {
    using Real = typename Lane::Real;
    const TriangleShape<Real> shape = shape_of<Lane>(t);
    const SymmetricTensor2<Real> e = green_strain(gradient_of(shape, u[1] - u[0], u[2] - u[0]));
    const SymmetricTensor2<Real> s = material::stress_of(stiffness<Lane>(t), e);
    const auto work = [&](const Real& xx, const Real& yy, const Real& xy) {
      return xx * e.xx + yy * e.yy + Real(2.0) * xy * e.xy;
    };
    Real density = Real(0.5) * work(s.xx, s.yy, s.xy);
    if (initial_xx_ != nullptr) {
      density += work(Lane::load(initial_xx_ + t), Lane::load(initial_yy_ + t),
                      Lane::load(initial_xy_ + t));
    }
    return Real(0.5) / shape.inverse_double_area * density;
  }

  /// Forces of the pore pressure, alpha times the mean of the three corners, (38) to (40).
  template <class Lane>
  PERCOLITH_DEVICE CornerVectors<typename Lane::Real>
  of_pores(Index t, const CornerVectors<typename Lane::Real>& u) const {
    using Real = typename Lane::Real;
    const Index first = mesh::corner_of(t, 0);
    const Real sum =
        (Lane::load(pore_pressure_ + first) + Lane::load(pore_pressure_ + first + block_width)) +
        Lane::load(pore_pressure_ + first + 2 * block_width);
    const Vec2<Real> a{Lane::load(ax_ + t), Lane::load(ay_ + t)};
    const Vec2<Real> b{Lane::load(bx_ + t), Lane::load(by_ + t)};
    return pressure_forces(a + (u[1] - u[0]), b + (u[2] - u[0]),
                           Lane::load(biot_ + t) * (Real(1.0 / 3.0) * sum));
  }

  /// By how much the pores of the triangles have grown at the displacements `u`, m2.
  template <class Lane>
  PERCOLITH_DEVICE typename Lane::Real
  pore_growth(Index t, const CornerVectors<typename Lane::Real>& u) const {
    using Real = typename Lane::Real;
    const Vec2<Real> a{Lane::load(ax_ + t), Lane::load(ay_ + t)};
    const Vec2<Real> b{Lane::load(bx_ + t), Lane::load(by_ + t)};
    return Lane::load(biot_ + t) * area_growth(a, b, u[1] - u[0], u[2] - u[0]);
  }

  /// Forces of the joints at the three edges.
  template <class Lane>
  PERCOLITH_DEVICE CornerVectors<typename Lane::Real> of_joints(Index first) const {
    using Real = typename Lane::Real;
    const auto at_end = [&](Index edge, Index flip) {
      const Index* code = edge_joint_ + first + edge * block_width;
      return Vec2<Real>{Lane::gather_signed(force_, code, flip, other_end),
                        Lane::gather_signed(force_ + block_width, code, flip, other_end)};
    };
    return {at_end(0, 0) + at_end(2, other_end), at_end(1, 0) + at_end(0, other_end),
            at_end(2, 0) + at_end(1, other_end)};
  }

private:
  /// Padding has edges too, so that its area is not zero.
  template <class Lane>
  PERCOLITH_DEVICE TriangleShape<typename Lane::Real> shape_of(Index t) const {
    using Real = typename Lane::Real;
    return triangle_shape(Vec2<Real>{Lane::load(ax_ + t), Lane::load(ay_ + t)},
                          Vec2<Real>{Lane::load(bx_ + t), Lane::load(by_ + t)});
  }

  template <class Lane>
  PERCOLITH_DEVICE material::PlaneStiffness<typename Lane::Real> stiffness(Index t) const {
    using Real = typename Lane::Real;
    if (uniform_[t / block_width] != 0) {
      const material::PlaneStiffness<double>& d = material_[material_of_[t]].stiffness;
      return {Real(d.xx_xx), Real(d.xx_yy), Real(d.yy_yy),
              Real(d.xx_xy), Real(d.yy_xy), Real(d.xy_xy)};
    }
    using Stiffness = material::PlaneStiffness<double>;
    const auto pick = [&](double Stiffness::*member) {
      return Lane::generate(
          [&](Index i) { return material_[material_of_[t + i]].stiffness.*member; });
    };
    return {pick(&Stiffness::xx_xx), pick(&Stiffness::xx_yy), pick(&Stiffness::yy_yy),
            pick(&Stiffness::xx_xy), pick(&Stiffness::yy_xy), pick(&Stiffness::xy_xy)};
  }

  const double* ax_;
  const double* ay_;
  const double* bx_;
  const double* by_;
  const double* initial_xx_;
  const double* initial_yy_;
  const double* initial_xy_;
  const double* viscosity_;
  const double* pore_pressure_;
  const double* biot_;
  const Index* material_of_;
  const std::uint8_t* uniform_;
  const SolidMaterial* material_;
  const Index* edge_joint_;
  const double* force_;
};

}  // namespace percolith::mechanics
