// SPDX-License-Identifier: BSD-3-Clause
#include "bench/support/solid_case.hpp"

#include "percolith/mechanics/build.hpp"
#include "percolith/mechanics/step_limit.hpp"

#include <cmath>
#include <utility>

#include "bench/support/grid_mesh.hpp"

namespace percolith::bench {
namespace {

using mechanics::Index;

mechanics::Ingredients granite(const mesh::Mesh& mesh, const SolidCase& what) {
  mechanics::Ingredients from;
  material::ElasticRock rock;
  rock.density = 2700.0;
  rock.young_modulus = 30e9;
  rock.poisson_ratio = 0.25;
  from.material = {{rock, {}, 0.0, 0.0}};
  from.region_material.assign(mesh.region_names.size(), 0);
  mechanics::JointKind kind;
  kind.strength.tensile_strength = 5e6;
  kind.strength.cohesion = 15e6;
  kind.strength.mode_1_energy = 50.0;
  kind.strength.mode_2_energy = 100.0;
  kind.friction = 0.6;
  kind.residual_friction = 0.6;
  from.kind = {kind};
  from.joint_kind.assign(mesh.joint.size(), 0);
  from.joint_state.assign(mesh.joint.size(), what.broken ? mechanics::JointState::broken
                                                         : mechanics::JointState::bonded);
  from.gravity = 9.81;
  return from;
}

/// Slow waves, too weak to break anything.
void set_waves(mechanics::Model& model) {
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    for (Index k = 0; k < 3; ++k) {
      const Index c = mesh::corner_of(t, k);
      const Point p = model.mesh.place_of(c);
      model.motion.vx[at(c)] = 0.01 * std::sin(6.0 * p.y);
      model.motion.vy[at(c)] = 0.01 * std::cos(5.0 * p.x);
    }
  }
}

/// Triangles keep their shape while their centres come closer to the middle.
void press_together(mechanics::Model& model, double share) {
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    const auto p = model.mesh.triangle_points(t);
    const Point centre = (1.0 / 3.0) * (p[0] + p[1] + p[2]);
    for (Index k = 0; k < 3; ++k) {
      const auto c = at(mesh::corner_of(t, k));
      model.motion.ux[c] = share * (0.5 - centre.x);
      model.motion.uy[c] = share * (0.5 - centre.y);
    }
  }
}

mechanics::ContactProperties contact_of(const mechanics::Model& model) {
  mechanics::ContactProperties contact;
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    const double size = mechanics::element_size(model.mesh, t);
    const double slope = mechanics::default_penalty * 30e9 / size;
    const auto p = model.mesh.triangle_points(t);
    double longest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point edge = p[(k + 1) % 3] - p[k];
      longest = std::max(longest, std::sqrt(dot(edge, edge)));
    }
    const double height = 2.0 * model.mesh.area(t) / longest;
    contact.penalty.push_back(slope * height / 6.0);
    contact.tangential_penalty.push_back(slope);
    contact.friction.push_back(0.6);
  }
  return contact;
}

}  // namespace

SolidBench make_solid(std::int32_t triangles, const SolidCase& what) {
  mesh::Mesh mesh = mesh::build_mesh(grid_mesh(cells_for(triangles)));
  mechanics::Ingredients from = granite(mesh, what);
  mechanics::Model model = mechanics::make_model(std::move(mesh), std::move(from));
  set_waves(model);
  mechanics::ContactProperties contact = contact_of(model);
  const double limit = mechanics::step_limits(model, contact.penalty).back().step;
  mechanics::Dynamics dynamics(std::move(model), {}, {}, std::move(contact));
  if (what.broken) {
    // After the start, at which nothing overlaps: contact then presses from its first step.
    Execution execution;
    static_cast<void>(dynamics.advance(1e-3 * limit, execution));
    press_together(dynamics.model(), 1e-3 / cells_for(triangles));
  }
  return {std::move(dynamics), 0.8 * limit};
}

SolidTraffic solid_traffic(const mechanics::Model& model) {
  const auto joints = static_cast<double>(model.mesh.joints());
  const auto triangles = static_cast<double>(model.mesh.triangles());
  constexpr double real = sizeof(double);
  constexpr double index = sizeof(Index);
  SolidTraffic traffic;
  // Corners, edge, stiffness and kind of a joint; its force is fetched to be written. The
  // displacements of the corners are read once for all their joints.
  traffic.joints = joints * (4 * index + 3 * real + index + 2 * 4 * real) + triangles * 6 * real;
  // Shape, mass, weight and material; joints of the edges and their forces; motion read and
  // written.
  traffic.triangles = triangles * (6 * real + index + 3 * index + 24 * real) + joints * 4 * real;
  return traffic;
}

}  // namespace percolith::bench
