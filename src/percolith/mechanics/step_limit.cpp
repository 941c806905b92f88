// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/step_limit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace percolith::mechanics {
namespace {

using Matrix3 = std::array<std::array<double, 3>, 3>;

/// Largest eigenvalue of the product of a symmetric positive definite and a symmetric matrix, by
/// the power method, enlarged by what it may lack.
double largest_eigenvalue(const Matrix3& a, const Matrix3& b) {
  std::array<double, 3> x{1.0, 0.7, 0.4};
  double value = 0.0;
  for (int iteration = 0; iteration < 40; ++iteration) {
    std::array<double, 3> y{};
    std::array<double, 3> z{};
    for (std::size_t i = 0; i < 3; ++i) {
      y[i] = b[i][0] * x[0] + b[i][1] * x[1] + b[i][2] * x[2];
    }
    for (std::size_t i = 0; i < 3; ++i) {
      z[i] = a[i][0] * y[0] + a[i][1] * y[1] + a[i][2] * y[2];
    }
    value = std::sqrt(z[0] * z[0] + z[1] * z[1] + z[2] * z[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      x[i] = z[i] / std::max(value, 1e-300);
    }
  }
  return 1.01 * value;
}

/// Largest eigenvalue of the stiffness of a triangle in N/m per metre of thickness, which is A B^T
/// D B with the strain-displacement matrix B: that of A D (B B^T).
double triangle_stiffness(const std::array<Point, 3>& p, const Matrix3& d) {
  const double area = 0.5 * cross(p[1] - p[0], p[2] - p[0]);
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point edge = p[(k + 2) % 3] - p[(k + 1) % 3];
    const Point gradient = (-0.5 / area) * clockwise(edge);
    xx += gradient.x * gradient.x;
    yy += gradient.y * gradient.y;
    xy += gradient.x * gradient.y;
  }
  const Matrix3 bb{{{xx, 0.0, xy}, {0.0, yy, xy}, {xy, xy, xx + yy}}};
  return area * largest_eigenvalue(d, bb);
}

/// `fluid` is alpha^2 M of pores that cannot drain, Pa.
Matrix3 stiffness_matrix(const material::PlaneStiffness<double>& d, double fluid) {
  return {{{d.xx_xx + fluid, d.xx_yy + fluid, d.xx_xy},
           {d.xx_yy + fluid, d.yy_yy + fluid, d.yy_xy},
           {d.xx_xy, d.yy_xy, d.xy_xy}}};
}

double joint_stiffness(const Model& model, Index triangle, Index k) {
  const Index code = model.triangles.edge_joint[at(mesh::corner_of(triangle, k))];
  const Index joint = code / (4 * block_width) * block_width + code % block_width;
  double stiffness = model.joints.stiffness[at(joint)];
  if (joint < model.mesh.joints() && model.joints.state[at(joint)] == JointState::closed) {
    stiffness = model.joints.full_stiffness[at(joint)];
  }
  return stiffness;
}

double edge_length(const std::array<Point, 3>& p, std::size_t k) {
  const Point edge = p[(k + 1) % 3] - p[k];
  return std::sqrt(dot(edge, edge));
}

/// Twice what the joints at a corner hold it with, over its mass (Gershgorin); the worst corner.
double joint_frequency(const Model& model, Index triangle, const std::array<Point, 3>& p,
                       double inverse_mass) {
  double worst = 0.0;
  for (Index k = 0; k < 3; ++k) {
    const Index before = (k + 2) % 3;
    const double held =
        0.5 * (joint_stiffness(model, triangle, k) * edge_length(p, at(k)) +
               joint_stiffness(model, triangle, before) * edge_length(p, at(before)));
    worst = std::max(worst, 2.0 * held * inverse_mass);
  }
  return worst;
}

void note(MotionLimit& limit, double step, Index triangle) {
  if (step < limit.step) {
    limit.step = step;
    limit.triangle = triangle;
  }
}

double penalty_of(std::span<const double> penalty, Index t) {
  return penalty.empty() ? 0.0 : penalty[at(t)];
}

/// Whether nothing but its supports moves a triangle, as that of a platen.
bool is_held(const Model& model, Index t) {
  const Index record = model.constraints.record[at(t / block_width)];
  if (record == mesh::none) {
    return false;
  }
  for (Index k = 0; k < 3; ++k) {
    const auto place =
        at(record * mesh::corners_per_block + mesh::corner_of(t, k) % mesh::corners_per_block);
    if (model.constraints.pxx[place] != 0.0 || model.constraints.pyy[place] != 0.0) {
      return false;
    }
  }
  return true;
}

/// Contact takes the place of joints: the stiffer of the two counts. Local damping, which goes by
/// the last velocity, points along the force of a mode that turns round at every step and makes it
/// so much stiffer.
double together(const Model& model, const Frequencies& f) {
  return (1.0 + model.damping.local) * (f.triangle + std::max(f.joints, f.contact));
}

/// By how much the mass of a triangle must grow for it to be stable alone up to `step` (s).
/// Frequencies fall as one over the mass: dt^2 square + 2 dt viscous = 4 is linear in it.
double mass_factor(const Model& model, Index t, std::span<const double> contact_penalty,
                   double step) {
  const Frequencies f = frequencies(model, t, penalty_of(contact_penalty, t));
  return 0.25 * (step * step * together(model, f) + 2.0 * step * (f.viscous + f.absorbing));
}

}  // namespace

Frequencies frequencies(const Model& model, Index t, double contact_penalty) {
  const auto p = model.mesh.triangle_points(t);
  const double inverse_mass = model.triangles.inverse_mass[at(t)];
  const SolidMaterial& material = model.material[at(model.triangles.material[at(t)])];
  Frequencies f;
  const double fluid = model.pores.stiffness.empty() ? 0.0 : model.pores.stiffness[at(t)];
  f.triangle = triangle_stiffness(p, stiffness_matrix(material.stiffness, fluid)) * inverse_mass;
  f.joints = joint_frequency(model, t, p, inverse_mass);
  const double area = model.mesh.area(t);
  for (std::size_t k = 0; k < 3; ++k) {
    const double length = edge_length(p, k);
    const double height = 2.0 * area / length;
    f.contact = std::max(f.contact, 2.0 * 6.0 * contact_penalty / height * length * inverse_mass);
  }
  if (!model.triangles.viscosity.empty()) {
    const double mu = model.triangles.viscosity[at(t)];
    f.viscous =
        triangle_stiffness(p, {{{2.0 * mu, 0, 0}, {0, 2.0 * mu, 0}, {0, 0, mu}}}) * inverse_mass;
  }
  if (!model.loads.resistance.empty()) {
    f.absorbing = model.loads.resistance[at(t)] * inverse_mass;
  }
  return f;
}

double stable_step(double square, double viscous) {
  if (square <= 0.0) {
    return viscous > 0.0 ? 2.0 / viscous : std::numeric_limits<double>::infinity();
  }
  // The root written so that a large rate of decay does not cancel.
  return 4.0 / (viscous + std::sqrt(viscous * viscous + 4.0 * square));
}

double stable_step(const Model& model, const Frequencies& f, double more) {
  return stable_step(together(model, f) + (1.0 + model.damping.local) * more,
                     f.viscous + f.absorbing);
}

std::vector<MotionLimit> step_limits(const Model& model, std::span<const double> contact_penalty) {
  MotionLimit triangles{"triangles"};
  MotionLimit joints{"joints"};
  MotionLimit contact{"contact"};
  MotionLimit viscosity{"viscosity"};
  MotionLimit absorbing{"absorbing boundary"};
  MotionLimit all{"all together"};
  // Where everything is held, the step still has to follow what the supports do to joints.
  bool any_free = false;
  for (Index t = 0; t < model.mesh.triangles() && !any_free; ++t) {
    any_free = model.triangles.inverse_mass[at(t)] > 0.0 && !is_held(model, t);
  }
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    if (model.triangles.inverse_mass[at(t)] == 0.0 || (any_free && is_held(model, t))) {
      continue;
    }
    const Frequencies f = frequencies(model, t, penalty_of(contact_penalty, t));
    note(triangles, stable_step(f.triangle, 0.0), t);
    note(joints, stable_step(f.joints, 0.0), t);
    note(contact, stable_step(f.contact, 0.0), t);
    note(viscosity, stable_step(0.0, f.viscous), t);
    note(absorbing, stable_step(0.0, f.absorbing), t);
    note(all, stable_step(model, f, 0.0), t);
  }
  std::vector<MotionLimit> limits;
  for (MotionLimit* limit : {&triangles, &joints, &contact, &viscosity, &absorbing}) {
    if (limit->triangle != mesh::none) {
      limits.push_back(*limit);
    }
  }
  std::sort(limits.begin(), limits.end(),
            [](const MotionLimit& a, const MotionLimit& b) { return a.step < b.step; });
  if (all.triangle != mesh::none) {
    limits.push_back(all);
  }
  return limits;
}

double scale_mass(Model& model, std::span<const double> contact_penalty, double step) {
  double before = 0.0;
  double added = 0.0;
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    double& inverse = model.triangles.inverse_mass[at(t)];
    if (inverse == 0.0 || is_held(model, t)) {
      continue;
    }
    const double mass = 1.0 / inverse;
    before += mass;
    const double factor = mass_factor(model, t, contact_penalty, step);
    if (factor > 1.0) {
      inverse /= factor;
      added += mass * (factor - 1.0);
    }
  }
  return before > 0.0 ? added / before : 0.0;
}

void even_masses(Model& model, std::span<const double> contact_penalty, double step) {
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    if (model.triangles.inverse_mass[at(t)] > 0.0) {
      model.triangles.inverse_mass[at(t)] /= mass_factor(model, t, contact_penalty, step);
    }
  }
}

}  // namespace percolith::mechanics
