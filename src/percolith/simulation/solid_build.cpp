// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/solid_build.hpp"

#include "percolith/core/error.hpp"
#include "percolith/mechanics/step_limit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace percolith::simulation {
namespace {

using mesh::Index;

double smallest_height(const mesh::Mesh& mesh, Index t) {
  const auto p = mesh.triangle_points(t);
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point edge = p[(k + 1) % 3] - p[k];
    longest = std::max(longest, std::sqrt(dot(edge, edge)));
  }
  return 2.0 * mesh.area(t) / longest;
}

void throw_bodies(const Setup& setup, mechanics::Model& model) {
  const BodyRegions regions = body_regions(setup, model.mesh);
  std::vector<Point> velocity;
  for (const auto& [name, body] : setup.body) {
    velocity.push_back(
        {body.initial_velocity_x.value_or(0.0), body.initial_velocity_y.value_or(0.0)});
  }
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    const Index body = regions.body[at(model.mesh.region[at(t)])];
    for (Index k = 0; body != mesh::none && k < 3; ++k) {
      model.motion.vx[at(mesh::corner_of(t, k))] = velocity[at(body)].x;
      model.motion.vy[at(mesh::corner_of(t, k))] = velocity[at(body)].y;
    }
  }
}

void refuse_overlap(const mechanics::Dynamics& dynamics) {
  const auto pairs = dynamics.overlapping();
  if (pairs.empty()) {
    return;
  }
  const mesh::Mesh& mesh = dynamics.model().mesh;
  const Point centre = mesh.triangle_centre(pairs.front()[0]);
  const auto region = [&](Index t) { return mesh.region_names[at(mesh.region[at(t)])]; };
  throw InputError(
      {{},
       "mesh.file",
       "",
       fmt::format("bodies overlap at the start: a triangle of region \"{}\" at ({:g}, "
                   "{:g}) lies in one of region \"{}\"; {} such pairs",
                   region(pairs.front()[0]), centre.x, centre.y, region(pairs.front()[1]),
                   pairs.size()),
       "bodies that touch or lie apart"});
}

/// Triangles along a fracture slide with its friction, of several with the smallest.
void set_friction_of_fractures(const mechanics::Model& model, std::size_t materials,
                               std::vector<double>& friction) {
  std::vector<std::uint8_t> set(friction.size(), 0);
  for (Index j = 0; j < model.mesh.joints(); ++j) {
    if (at(mechanics::owner_of(model, j)) < materials) {
      continue;
    }
    const double own = model.kind[at(model.joints.strength[at(j)])].residual_friction;
    for (const auto& side : model.mesh.joint[at(j)].corner) {
      const auto t = at(mesh::triangle_of(side[0]));
      friction[t] = set[t] != 0 ? std::min(friction[t], own) : own;
      set[t] = 1;
    }
  }
}

}  // namespace

mechanics::ContactProperties contact_properties(const Setup& setup, const mechanics::Model& model) {
  mechanics::ContactProperties result;
  std::vector<const Material*> material;
  for (const auto& [name, table] : setup.material) {
    material.push_back(&table);
  }
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    const Index number = model.triangles.material[at(t)];
    const Material& m = *material[at(number)];
    const double height = smallest_height(model.mesh, t);
    const double joints =
        m.strength.joint_penalty.value_or(mechanics::default_penalty * m.solid.young_modulus) /
        mechanics::element_size(model.mesh, t);
    // Two faces that overlap by d press with 6 p_n d/height (theory.md section 11).
    const double penalty = setup.contact.penalty.value_or(joints * height / 6.0);
    result.penalty.push_back(penalty);
    result.tangential_penalty.push_back(
        setup.contact.tangential_penalty.value_or(6.0 * penalty / height));
    result.friction.push_back(model.kind[at(number)].residual_friction);
  }
  set_friction_of_fractures(model, material.size(), result.friction);
  return result;
}

SolidStart build_solid(const Setup& setup, const mesh::GmshMesh& file,
                       const std::function<void(mechanics::Model&)>& prepare) {
  mesh::Mesh mesh = mesh::build_mesh(file);
  mechanics::Ingredients ingredients = solid_ingredients(setup, mesh);
  mechanics::Model model = mechanics::make_model(std::move(mesh), std::move(ingredients));
  if (setup.in_situ) {
    mechanics::set_initial_stress(
        model, [&](const Point& p) { return in_situ_stress(*setup.in_situ, p); });
  }
  if (prepare) {
    prepare(model);
  }
  throw_bodies(setup, model);
  mechanics::ContactProperties contact = contact_properties(setup, model);
  mechanics::LoadList loads = solid_loads(setup, model);
  mechanics::SupportSet supports = solid_supports(setup, model);
  double added = 0.0;
  if (setup.time.mass_scaling_step) {
    model.loads.resistance = mechanics::LoadSet(model.mesh, loads).resistances(model.mesh);
    added = mechanics::scale_mass(model, contact.penalty, *setup.time.mass_scaling_step);
  }
  SolidStart start{mechanics::Dynamics(std::move(model), std::move(loads), std::move(supports),
                                       std::move(contact)),
                   added};
  refuse_overlap(start.dynamics);
  return start;
}

}  // namespace percolith::simulation
