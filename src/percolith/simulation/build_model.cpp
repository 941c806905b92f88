// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/build_model.hpp"

#include "percolith/core/error.hpp"
#include "percolith/simulation/groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace percolith::simulation {
namespace {

using mesh::Index;

/// The rock of every region.
std::vector<material::PoreRock> rock_of_regions(const Setup& setup, const mesh::Mesh& mesh) {
  std::vector<material::PoreRock> rock;
  for (const std::string& name : material_of_regions(setup, mesh)) {
    rock.push_back(setup.material.at(name).rock);
  }
  return rock;
}

/// Whether a fracture is bonded at first, so that no fluid is in it.
bool is_bonded(const Setup& setup, const FractureGroup& fracture) {
  return setup.model.physics == Physics::coupled && fracture.bond == Bond::cohesive;
}

void break_fractures(const Setup& setup, seepage::Model& model) {
  Index group = 0;
  for (const auto& [name, fracture] : setup.fracture) {
    if (is_bonded(setup, fracture)) {
      ++group;
      continue;
    }
    const std::string key = "fracture." + name + ".groups";
    const std::vector<Index> joints = fracture_joints(model.mesh, fracture.groups, key);
    for (const Index j : joints) {
      if (model.cracks.is_broken(j)) {
        const auto other = std::next(setup.fracture.begin(), model.crack.group[at(j)])->first;
        const Point p = model.mesh.vertex[at(model.mesh.joint[at(j)].vertex[0])];
        throw InputError({{},
                          key,
                          "",
                          fmt::format("its edge at ({:g}, {:g}) already belongs to fracture.{}",
                                      p.x, p.y, other),
                          "each edge in one fracture table"});
      }
    }
    seepage::break_joints(model, joints, group++);
  }
}

}  // namespace

std::vector<std::string> fracture_table_names(const Setup& setup) {
  std::vector<std::string> names;
  for (const auto& [name, fracture] : setup.fracture) {
    names.push_back(name);
  }
  return names;
}

seepage::Model build_model(const Setup& setup, const mesh::GmshMesh& file) {
  mesh::Mesh mesh = mesh::build_mesh(file);
  std::vector<material::PoreRock> rock = rock_of_regions(setup, mesh);
  std::vector<material::Fracture> fracture;
  for (const auto& [name, group] : setup.fracture) {
    fracture.push_back(group.fracture);
  }
  if (setup.new_cracks) {
    fracture.push_back(setup.new_cracks->fracture);
  }
  for (material::Fracture& f : fracture) {
    f.clamped_storage = setup.model.crack_storage == CrackStorage::clamped;
  }
  seepage::Model model = seepage::make_model(
      std::move(mesh), setup.fluid, setup.model.gravity, std::move(rock), std::move(fracture),
      setup.model.pore_joints, setup.model.joint_factor, setup.model.saturation_weight);
  break_fractures(setup, model);
  model.conditions = build_conditions(setup, model);
  model.let_in.assign(model.conditions.name.size(), {});
  model.rate.assign(model.conditions.name.size(), 0.0);
  set_initial_state(setup, model);
  return model;
}

}  // namespace percolith::simulation
