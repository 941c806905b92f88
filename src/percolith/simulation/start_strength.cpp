// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/start_strength.hpp"

#include "percolith/core/quantity_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace percolith::simulation {
namespace {

using mesh::Index;

/// What a joint bears at one of its points and what it has to, Pa.
struct Load {
  double normal = 0.0;  ///< t_n, tension positive
  double shear = 0.0;   ///< |t_s|
  double tensile_strength = 0.0;
  double shear_strength = 0.0;

  [[nodiscard]] double tensile_excess() const { return normal - tensile_strength; }
  [[nodiscard]] double shear_excess() const { return shear - shear_strength; }
  [[nodiscard]] double excess() const { return std::max(tensile_excess(), shear_excess()); }
  /// Beyond what round-off makes of a stress that is just borne.
  [[nodiscard]] bool is_too_much() const {
    constexpr double round_off = 1e-6;
    return excess() > round_off * (std::abs(normal) + shear);
  }
};

/// At the worse one of the points of a joint.
Load load_of(const mechanics::Model& model, Index j) {
  const mechanics::Joints& joints = model.joints;
  const mechanics::JointKind& kind = model.kind[at(joints.strength[at(j)])];
  const double factor = joints.factor.empty() ? 1.0 : joints.factor[at(j)];
  const double k = joints.full_stiffness[at(j)];
  Load worst;
  for (std::size_t g = 0; g < 2; ++g) {
    Load load;
    load.normal = k * joints.opening_start[g][at(j)];
    load.shear = std::abs(k * joints.slip_start[g][at(j)]);
    load.tensile_strength = factor * kind.strength.tensile_strength;
    load.shear_strength =
        factor * kind.strength.cohesion + std::max(0.0, -load.normal) * kind.friction;
    worst = g == 0 || load.excess() > worst.excess() ? load : worst;
  }
  return worst;
}

/// The joints of one material or fracture.
struct Overloaded {
  std::int64_t joints = 0, failing = 0;
  Load worst;
  Index place = mesh::none;
};

std::map<Index, Overloaded> find_overloaded(const mechanics::Model& model) {
  std::map<Index, Overloaded> found;
  for (Index j = 0; j < model.mesh.joints(); ++j) {
    if (model.joints.state[at(j)] != mechanics::JointState::bonded) {
      continue;
    }
    Overloaded& of = found[mechanics::owner_of(model, j)];
    ++of.joints;
    const Load load = load_of(model, j);
    if (load.is_too_much()) {
      ++of.failing;
      if (of.place == mesh::none || load.excess() > of.worst.excess()) {
        of.worst = load;
        of.place = j;
      }
    }
  }
  return found;
}

std::string reason_of(const Load& load) {
  if (load.tensile_excess() >= load.shear_excess()) {
    return fmt::format("the tension across a joint is {}, and its tensile_strength {}",
                       pressure_text(load.normal), pressure_text(load.tensile_strength));
  }
  return fmt::format("the shear stress along a joint is {}, and its cohesion and friction bear {} "
                     "under a normal stress of {}",
                     pressure_text(load.shear), pressure_text(load.shear_strength),
                     pressure_text(load.normal));
}

}  // namespace

std::vector<std::string> start_strength_warnings(const mechanics::Model& model,
                                                 std::span<const std::string> names) {
  std::vector<std::string> warnings;
  if (model.joints.opening_start[0].empty()) {
    return warnings;
  }
  for (const auto& [owner, of] : find_overloaded(model)) {
    if (of.failing == 0) {
      continue;
    }
    const Point p = model.mesh.middle_of(model.mesh.joint[at(of.place)].vertex);
    warnings.push_back(fmt::format(
        "the stress at the start is more than the joints of {0} bear: {1} of {2} fail at once. At "
        "({3:g}, {4:g}) {5} (effective, tension positive). Look at the signs and units of "
        "[in_situ], "
        "where compression is negative, at the initial pressure and at the strengths",
        names[at(owner)], of.failing, of.joints, p.x, p.y, reason_of(of.worst)));
  }
  return warnings;
}

}  // namespace percolith::simulation
