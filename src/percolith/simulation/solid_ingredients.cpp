// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/error.hpp"
#include "percolith/simulation/groups.hpp"
#include "percolith/simulation/solid_build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <utility>

namespace percolith::simulation {
namespace {

using mechanics::JointKind;
using mechanics::JointState;
using mesh::Index;

/// Strengths of joints that never carry anything, so that no term of the law divides zero by zero.
JointKind idle_kind() {
  JointKind kind;
  kind.strength.tensile_strength = 1.0;
  kind.strength.cohesion = 1.0;
  kind.strength.mode_1_energy = 1.0;
  kind.strength.mode_2_energy = 1.0;
  return kind;
}

void set_friction(JointKind& kind, double angle) {
  kind.friction = std::tan(angle);
  kind.residual_friction = std::tan(kind.strength.residual_friction_angle.value_or(angle));
}

JointKind kind_of(const Material& material) {
  JointKind kind = idle_kind();
  if (material.joints == RockJoints::breakable) {
    kind.strength = material.strength;
  }
  kind.strength.joint_penalty = material.strength.joint_penalty;
  kind.strength.friction_angle = material.strength.friction_angle;
  kind.strength.residual_friction_angle = material.strength.residual_friction_angle;
  set_friction(kind, material.strength.friction_angle.value_or(0.0));
  return kind;
}

/// The smaller one of two values that may be absent.
std::optional<double> smaller_of(const std::optional<double>& a, const std::optional<double>& b) {
  return a && b ? std::min(*a, *b) : (a ? a : b);
}

/// What a fracture has from the rocks on both sides: the smaller friction, the softer penalty. A
/// rock that says nothing of its friction leaves it to the other one.
JointKind between(const JointKind& first, const JointKind& second) {
  JointKind both = first;
  both.strength.joint_penalty =
      smaller_of(first.strength.joint_penalty, second.strength.joint_penalty);
  if (!first.strength.friction_angle && second.strength.friction_angle) {
    both.friction = second.friction;
    both.residual_friction = second.residual_friction;
  } else if (second.strength.friction_angle) {
    both.friction = std::min(first.friction, second.friction);
    both.residual_friction = std::min(first.residual_friction, second.residual_friction);
  }
  return both;
}

/// A fracture without a friction angle of its own has that of the rocks beside it.
JointKind kind_of(const FractureGroup& group, const JointKind& rock) {
  JointKind kind = idle_kind();
  if (group.bond == Bond::cohesive) {
    kind.strength = group.strength;
  }
  kind.strength.joint_penalty =
      group.strength.joint_penalty ? group.strength.joint_penalty : rock.strength.joint_penalty;
  kind.strength.residual_friction_angle = group.strength.residual_friction_angle;
  if (group.strength.friction_angle) {
    set_friction(kind, *group.strength.friction_angle);
  } else {
    kind.friction = rock.friction;
    kind.residual_friction = group.strength.residual_friction_angle
                                 ? std::tan(*group.strength.residual_friction_angle)
                                 : rock.residual_friction;
  }
  return kind;
}

/// What the regions of the mesh are made of, by number of the material table.
class Regions {
public:
  Regions(const Setup& setup, const mesh::Mesh& mesh)
      : mesh_(&mesh), bodies_(body_regions(setup, mesh)) {
    for (const std::string& name : material_of_regions(setup, mesh)) {
      const auto found = setup.material.find(name);
      material_.push_back(static_cast<Index>(std::distance(setup.material.begin(), found)));
      elastic_.push_back(found->second.joints == RockJoints::elastic ? 1 : 0);
      tensile_.push_back(found->second.strength.tensile_strength);
    }
  }
  [[nodiscard]] const std::vector<Index>& materials() const { return material_; }

  /// State of a joint that belongs to no fracture.
  [[nodiscard]] JointState state(Index joint) const {
    const auto [a, b] = sides(joint);
    if (bodies_.rigid[a] != 0 && bodies_.rigid[b] != 0 && bodies_.body[a] == bodies_.body[b]) {
      return JointState::rigid;
    }
    return elastic_[a] != 0 && elastic_[b] != 0 ? JointState::tied : JointState::bonded;
  }
  /// Materials on both sides.
  [[nodiscard]] std::pair<Index, Index> rocks(Index joint) const {
    const auto [a, b] = sides(joint);
    return {material_[a], material_[b]};
  }
  /// Kind of the weaker side; a side without breakable joints has none.
  [[nodiscard]] Index kind(Index joint) const {
    const auto [a, b] = sides(joint);
    if (elastic_[a] != elastic_[b]) {
      return material_[elastic_[a] != 0 ? b : a];
    }
    // Of sides that are equally strong the one of the lower number, whichever way the edge runs.
    const auto rank = [&](std::size_t side) { return std::pair{tensile_[side], material_[side]}; };
    return material_[rank(b) < rank(a) ? b : a];
  }

private:
  [[nodiscard]] std::pair<std::size_t, std::size_t> sides(Index joint) const {
    const auto& corner = mesh_->joint[at(joint)].corner;
    const auto region = [&](std::size_t side) {
      return at(mesh_->region[at(mesh::triangle_of(corner[side][0]))]);
    };
    return {region(0), region(1)};
  }
  const mesh::Mesh* mesh_;
  BodyRegions bodies_;
  std::vector<Index> material_;
  std::vector<std::uint8_t> elastic_;
  std::vector<double> tensile_;
};

/// The kinds of joints of one fracture, one for each pair of rocks on its sides.
class FractureKinds {
public:
  FractureKinds(const FractureGroup& group, Index owner, std::vector<JointKind>& kinds)
      : group_(&group), owner_(owner), kinds_(&kinds) {}
  Index of(std::pair<Index, Index> rocks) {
    if (rocks.second < rocks.first) {
      std::swap(rocks.first, rocks.second);
    }
    const auto [entry, is_new] = of_rocks_.try_emplace(rocks, static_cast<Index>(kinds_->size()));
    if (is_new) {
      JointKind kind =
          kind_of(*group_, between((*kinds_)[at(rocks.first)], (*kinds_)[at(rocks.second)]));
      kind.owner = owner_;
      kinds_->push_back(kind);
    }
    return entry->second;
  }

private:
  const FractureGroup* group_;
  Index owner_;
  std::vector<JointKind>* kinds_;
  std::map<std::pair<Index, Index>, Index> of_rocks_;
};

void add_fractures(const Setup& setup, const mesh::Mesh& mesh, const Regions& regions,
                   mechanics::Ingredients& result) {
  std::vector<std::uint8_t> taken(mesh.joint.size(), 0);
  auto owner = static_cast<Index>(setup.material.size());
  for (const auto& [name, group] : setup.fracture) {
    const std::string key = "fracture." + name + ".groups";
    const std::vector<Index> joints = fracture_joints(mesh, group.groups, key);
    FractureKinds kinds(group, owner++, result.kind);
    for (const Index j : joints) {
      if (taken[at(j)] != 0) {
        const Point p = mesh.vertex[at(mesh.joint[at(j)].vertex[0])];
        throw InputError(
            {{},
             key,
             "",
             fmt::format("its edge at ({:g}, {:g}) already belongs to another fracture "
                         "table",
                         p.x, p.y),
             "each edge in one fracture table"});
      }
      taken[at(j)] = 1;
      result.joint_kind[at(j)] = kinds.of(regions.rocks(j));
      result.joint_state[at(j)] =
          group.bond == Bond::broken ? JointState::closed : JointState::bonded;
    }
  }
}

/// Strengths scatter by a Weibull distribution of mean 1: x = (-ln U)^(1/m)/Gamma(1 + 1/m).
void add_scatter(const Setup& setup, mechanics::Ingredients& result) {
  Index number = 0;
  for (const auto& [name, material] : setup.material) {
    if (material.weibull_modulus) {
      result.joint_factor.resize(result.joint_kind.size(), 1.0);
      std::mt19937_64 random(static_cast<std::uint64_t>(material.weibull_seed));
      const double inverse = 1.0 / *material.weibull_modulus;
      const double scale = 1.0 / std::tgamma(1.0 + inverse);
      for (std::size_t j = 0; j < result.joint_kind.size(); ++j) {
        // The numbers between 0 and 1 that a double has 53 bits for; not 0.
        const double u = (static_cast<double>(random() >> 11U) + 0.5) * 0x1p-53;
        if (result.joint_kind[j] == number) {
          result.joint_factor[j] = scale * std::pow(-std::log(u), inverse);
        }
      }
    }
    ++number;
  }
}

}  // namespace

BodyRegions body_regions(const Setup& setup, const mesh::Mesh& mesh) {
  BodyRegions result{std::vector<Index>(mesh.region_names.size(), mesh::none),
                     std::vector<std::uint8_t>(mesh.region_names.size(), 0)};
  Index number = 0;
  for (const auto& [name, body] : setup.body) {
    for (const Index r : find_regions(mesh, body.regions, "body." + name + ".regions")) {
      result.body[at(r)] = number;
      result.rigid[at(r)] = body.rigid ? 1 : 0;
    }
    ++number;
  }
  return result;
}

std::vector<std::string> joint_kind_names(const Setup& setup) {
  std::vector<std::string> names;
  for (const auto& [name, material] : setup.material) {
    names.push_back(name);
  }
  for (const auto& [name, group] : setup.fracture) {
    names.push_back(name);
  }
  return names;
}

mechanics::Ingredients solid_ingredients(const Setup& setup, const mesh::Mesh& mesh) {
  const Regions regions(setup, mesh);
  mechanics::Ingredients result;
  result.plane = setup.model.plane;
  result.gravity = setup.model.gravity;
  result.damping = {setup.damping.nodal_viscosity, setup.damping.local};
  for (const auto& [name, material] : setup.material) {
    result.material.push_back(
        {material.solid, {}, setup.damping.element_viscosity, setup.damping.viscosity_ratio});
    result.kind.push_back(kind_of(material));
    result.kind.back().owner = static_cast<Index>(result.kind.size()) - 1;
  }
  result.region_material = regions.materials();
  for (Index j = 0; j < mesh.joints(); ++j) {
    result.joint_kind.push_back(regions.kind(j));
    result.joint_state.push_back(regions.state(j));
  }
  add_fractures(setup, mesh, regions, result);
  add_scatter(setup, result);
  return result;
}

Tensor in_situ_stress(const InSitu& in_situ, const Point& place) {
  const double height = place.y - in_situ.datum;
  return {in_situ.stress_xx + in_situ.gradient_xx * height,
          in_situ.stress_yy + in_situ.gradient_yy * height,
          in_situ.stress_xy + in_situ.gradient_xy * height};
}

double in_situ_across(const InSitu& in_situ, const Point& place) {
  return in_situ.stress_zz + in_situ.gradient_zz * (place.y - in_situ.datum);
}

}  // namespace percolith::simulation
