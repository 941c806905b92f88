// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/strain.hpp"

#include <cmath>

namespace percolith::mechanics {

TriangleStrain triangle_strain(const Model& model, Index t, double back) {
  const Triangles& tri = model.triangles;
  const auto shape =
      triangle_shape(Point{tri.ax[at(t)], tri.ay[at(t)]}, Point{tri.bx[at(t)], tri.by[at(t)]});
  std::array<Point, 3> u;
  for (Index k = 0; k < 3; ++k) {
    const auto c = at(mesh::corner_of(t, k));
    u[at(k)] = {model.motion.ux[c] - back * model.motion.vx[c],
                model.motion.uy[c] - back * model.motion.vy[c]};
  }
  const Gradient<double> h = gradient_of(shape, u[1] - u[0], u[2] - u[0]);
  return {h, green_strain(h)};
}

TriangleStress triangle_stress(const Model& model, Index t) {
  const TriangleStrain strained = triangle_strain(model, t);
  const SolidMaterial& material = model.material[at(model.triangles.material[at(t)])];
  const Tensor& e = strained.strain;
  Tensor s = material::stress_of(material.stiffness, e);
  const auto across = material::across_stiffness(material.rock, model.plane);
  if (!model.triangles.initial_xx.empty()) {
    s.xx += model.triangles.initial_xx[at(t)];
    s.yy += model.triangles.initial_yy[at(t)];
    s.xy += model.triangles.initial_xy[at(t)];
  }
  return {cauchy_stress(strained.gradient, s),
          across.xx * e.xx + across.yy * e.yy + across.xy * 2.0 * e.xy};
}

Principal principal(const Tensor& s) {
  const double mean = 0.5 * (s.xx + s.yy);
  const double half = 0.5 * (s.xx - s.yy);
  const double radius = std::sqrt(half * half + s.xy * s.xy);
  const double angle = 0.5 * std::atan2(s.xy, half);
  return {mean + radius, mean - radius, {std::cos(angle), std::sin(angle)}};
}

}  // namespace percolith::mechanics
