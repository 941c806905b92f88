// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/build.hpp"
#include "percolith/mechanics/dynamics.hpp"
#include "percolith/mechanics/solid_forces.hpp"
#include "percolith/mechanics/step_limit.hpp"

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "unit/support/grid.hpp"
#include "unit/support/places.hpp"

// Models of dry rock for tests, and what one asks of them.
namespace percolith::test {

using mechanics::JointState;
using mesh::Index;

inline material::ElasticRock elastic_rock(double young_modulus = 10e9, double poisson_ratio = 0.25,
                                          double density = 2500.0) {
  material::ElasticRock rock;
  rock.density = density;
  rock.young_modulus = young_modulus;
  rock.poisson_ratio = poisson_ratio;
  return rock;
}

inline mechanics::JointKind joint_kind(double tensile, double cohesion, double mode_1,
                                       double mode_2, double friction = 0.6,
                                       double residual_friction = 0.4) {
  mechanics::JointKind kind;
  kind.strength.tensile_strength = tensile;
  kind.strength.cohesion = cohesion;
  kind.strength.mode_1_energy = mode_1;
  kind.strength.mode_2_energy = mode_2;
  kind.friction = friction;
  kind.residual_friction = residual_friction;
  return kind;
}

/// Joints that no load of a test breaks.
inline mechanics::JointKind strong() {
  return joint_kind(1e12, 1e12, 1e9, 1e9);
}

struct SolidOptions {
  material::ElasticRock rock = elastic_rock();
  mechanics::JointKind kind = strong();
  JointState joints = JointState::bonded;
  std::map<std::string, JointState> curves{};  ///< states along named curves
  material::Plane plane = material::Plane::strain;
  double gravity = 0.0;
  mechanics::Damping damping{};
  double viscosity = 0.0;
  double viscosity_ratio = 0.0;
};

inline mechanics::Model make_solid(const mesh::GmshMesh& file, const SolidOptions& options = {}) {
  mesh::Mesh mesh = mesh::build_mesh(file);
  mechanics::Ingredients from;
  from.plane = options.plane;
  from.gravity = options.gravity;
  from.material = {{options.rock, {}, options.viscosity, options.viscosity_ratio}};
  from.region_material.assign(mesh.region_names.size(), 0);
  from.kind = {options.kind};
  from.joint_kind.assign(mesh.joint.size(), 0);
  from.joint_state.assign(mesh.joint.size(), options.joints);
  for (const auto& [curve, state] : options.curves) {
    for (const Index j : mesh.curves.at(curve).joints) {
      from.joint_state[at(j)] = state;
    }
  }
  from.damping = options.damping;
  return mechanics::make_model(std::move(mesh), std::move(from));
}

/// Contact as stiff as the joints, with the residual friction of the first kind of joints.
inline mechanics::ContactProperties contact_of(const mechanics::Model& model) {
  mechanics::ContactProperties contact;
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    const auto p = model.mesh.triangle_points(t);
    const double longest =
        std::max({distance(p[0], p[1]), distance(p[1], p[2]), distance(p[2], p[0])});
    const double height = 2.0 * model.mesh.area(t) / longest;
    const double joints = mechanics::default_penalty * model.material[0].rock.young_modulus /
                          mechanics::element_size(model.mesh, t);
    contact.penalty.push_back(joints * height / 6.0);
    contact.tangential_penalty.push_back(joints);
    contact.friction.push_back(model.kind[0].residual_friction);
  }
  return contact;
}

inline mechanics::Dynamics make_dynamics(mechanics::Model model, mechanics::LoadList loads = {},
                                         mechanics::SupportSet supports = {}) {
  mechanics::ContactProperties contact = contact_of(model);
  return {std::move(model), std::move(loads), std::move(supports), std::move(contact)};
}

/// The longest stable step, all mechanisms together, s.
inline double stable_step(const mechanics::Dynamics& dynamics) {
  return mechanics::step_limits(dynamics.model(), dynamics.contact_penalty()).back().step;
}

inline void advance(mechanics::Dynamics& dynamics, double dt, int steps) {
  Execution execution;
  for (int i = 0; i < steps; ++i) {
    dynamics.advance(dt, execution);
  }
}

/// Calls `visit(triangle, corner)` for every corner of every triangle.
template <class Visit>
void for_each_corner(const mesh::Mesh& mesh, const Visit& visit) {
  for (Index t = 0; t < mesh.triangles(); ++t) {
    for (Index k = 0; k < 3; ++k) {
      visit(t, mesh::corner_of(t, k));
    }
  }
}

/// Gives every corner the displacement of its undeformed place.
template <class Field>
void displace(mechanics::Model& model, const Field& field) {
  for_each_corner(model.mesh, [&](Index, Index c) {
    const Point u = field(model.mesh.place_of(c));
    model.motion.ux[at(c)] = u.x;
    model.motion.uy[at(c)] = u.y;
  });
}

/// Gives every corner the velocity of its undeformed place.
template <class Field>
void set_velocity(mechanics::Model& model, const Field& field) {
  for_each_corner(model.mesh, [&](Index, Index c) {
    const Point v = field(model.mesh.place_of(c));
    model.motion.vx[at(c)] = v.x;
    model.motion.vy[at(c)] = v.y;
  });
}

inline Point displacement(const mechanics::Model& model, Index corner) {
  return {model.motion.ux[at(corner)], model.motion.uy[at(corner)]};
}

/// Displacement of a vertex, the mean of its corners.
inline Point displacement_at(const mechanics::Model& model, Point place) {
  const auto corners = model.mesh.vertex_corners.row(vertex_at(model.mesh, place));
  Point sum{};
  for (const Index c : corners) {
    sum = sum + displacement(model, c);
  }
  return (1.0 / static_cast<double>(corners.size())) * sum;
}

/// Forces of the stress on the corners of a triangle in the present positions, N/m.
inline mechanics::CornerVectors<double> stress_forces(const mechanics::Model& model, Index t) {
  const Index first = mesh::corner_of(t, 0);
  const mechanics::Motion& m = model.motion;
  mechanics::CornerVectors<double> viscous;
  return mechanics::SolidForces(model).of_stress<ScalarLane>(
      t, mechanics::load_corners<ScalarLane>(m.ux.data(), m.uy.data(), first),
      mechanics::load_corners<ScalarLane>(m.vx.data(), m.vy.data(), first), viscous);
}

/// Forces of the bonded joints on all corner slots in the present positions, N/m.
inline std::vector<Point> joint_forces_of(mechanics::Model& model) {
  const mechanics::JointTable table = mechanics::joint_table(model);
  Execution execution;
  execution.for_each("joints", model.mesh.joints(), mechanics::JointForces(model, table));
  std::vector<Point> force(at(model.mesh.corners()));
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    const auto f = mechanics::SolidForces(model).of_joints<ScalarLane>(mesh::corner_of(t, 0));
    for (Index k = 0; k < 3; ++k) {
      force[at(mesh::corner_of(t, k))] = f[at(k)];
    }
  }
  return force;
}

/// Linear momentum, kg/s per metre of thickness times m.
inline Point momentum(const mechanics::Model& model) {
  Point sum{};
  for_each_corner(model.mesh, [&](Index t, Index c) {
    const double mass = 1.0 / model.triangles.inverse_mass[at(t)];
    sum = sum + mass * Point{model.motion.vx[at(c)], model.motion.vy[at(c)]};
  });
  return sum;
}

inline std::string state_hash(const mechanics::Dynamics& dynamics) {
  StateHash hash;
  dynamics.add_to(hash);
  return hash.text();
}

/// Edges of the boundary along a named curve.
inline std::vector<Index> edges_of(const mechanics::Model& model, const std::string& curve) {
  return model.mesh.curves.at(curve).boundary;
}

/// Holds the corners where `where(place)` holds along a direction.
template <class Where>
void hold_where(const mechanics::Model& model, const Where& where, Point direction, Index motion,
                std::vector<mechanics::Held>& held) {
  for_each_corner(model.mesh, [&](Index, Index c) {
    if (where(model.mesh.place_of(c))) {
      held.push_back({c, direction, motion});
    }
  });
}

}  // namespace percolith::test
