// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/resolution.hpp"

#include "percolith/mechanics/build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace percolith::simulation {
namespace {

using mesh::Index;

/// Cohesive length of a joint, m; absent where it cannot break in tension or has no strength.
/// Strengths and energies of weaker joints fall alike, so that their cohesive length grows: the
/// mean one counts.
std::optional<double> cohesive_length(const mechanics::Model& model, Index j) {
  if (model.joints.state[at(j)] != mechanics::JointState::bonded) {
    return std::nullopt;
  }
  const auto& strength = model.kind[at(model.joints.strength[at(j)])].strength;
  if (strength.tensile_strength == 0.0) {
    return std::nullopt;
  }
  return mechanics::softer_modulus(model, j) * strength.mode_1_energy /
         (strength.tensile_strength * strength.tensile_strength);
}

/// Makes `worst` the joint where it is coarser.
void take_coarser(const mechanics::Model& model, Index j, Index vertex, std::string_view what,
                  std::optional<Resolution>& worst) {
  const auto length = cohesive_length(model, j);
  if (!length) {
    return;
  }
  const double size = model.joints.size[at(j)];
  if (!worst || *length / size < worst->ratio) {
    worst = {*length / size, *length, size, j, model.mesh.vertex[at(vertex)], std::string(what)};
  }
}

}  // namespace

std::optional<Resolution> coarsest(const mechanics::Model& model) {
  std::optional<Resolution> worst;
  for (Index j = 0; j < model.mesh.joints(); ++j) {
    take_coarser(model, j, model.mesh.joint[at(j)].vertex[0], "", worst);
  }
  return worst;
}

std::optional<Resolution> coarsest_at(const mechanics::Model& model,
                                      std::span<const CrackStart> starts) {
  std::optional<Resolution> worst;
  for (const CrackStart& start : starts) {
    for (const Index j : model.mesh.vertex_joints.row(start.vertex)) {
      take_coarser(model, j, start.vertex, start.what, worst);
    }
  }
  return worst;
}

double resolved_distance(const mechanics::Model& model, std::span<const CrackStart> starts) {
  double nearest = std::numeric_limits<double>::infinity();  // squared, m2
  for (Index j = 0; j < model.mesh.joints(); ++j) {
    const auto length = cohesive_length(model, j);
    if (!length || *length >= resolved * model.joints.size[at(j)]) {
      continue;
    }
    const Point middle = model.mesh.middle_of(model.mesh.joint[at(j)].vertex);
    for (const CrackStart& start : starts) {
      const Point way = middle - model.mesh.vertex[at(start.vertex)];
      nearest = std::min(nearest, dot(way, way));
    }
  }
  return std::sqrt(nearest);
}

std::string resolution_warning(const mechanics::Model& model, std::span<const CrackStart> starts) {
  std::optional<Resolution> worst = coarsest_at(model, starts);
  if (!worst) {
    worst = coarsest(model);
  }
  if (!worst || worst->ratio >= resolved) {
    return {};
  }
  const std::string place = worst->what.empty()
                                ? fmt::format("at ({:g}, {:g})", worst->place.x, worst->place.y)
                                : fmt::format("where cracks start, at {} ({:g}, {:g}),",
                                              worst->what, worst->place.x, worst->place.y);
  return fmt::format(
      "elements of {:.3g} m {} do not resolve the cohesive length E' G_I/f_t^2 = {:.3g} m: {:.2g} "
      "of them fit into it, where three should. Strength rather than fracture energy rules there, "
      "and results depend on the mesh. Take elements of at most {:.2g} m there, or a larger "
      "mode_1_energy",
      worst->size, place, worst->length, worst->ratio, worst->length / resolved);
}

}  // namespace percolith::simulation
