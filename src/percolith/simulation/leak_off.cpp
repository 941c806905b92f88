// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/leak_off.hpp"

#include "percolith/mechanics/build.hpp"
#include "percolith/simulation/build_model.hpp"
#include "percolith/simulation/groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

namespace percolith::simulation {
namespace {

using mesh::Index;

/// How far fluid comes into a triangle, against its size.
struct Penetration {
  double ratio = std::numeric_limits<double>::infinity();  ///< depth over element size
  double depth = 0.0;                                      ///< l, m
  double size = 0.0;                                       ///< h, m
  double walls = 0.0;  ///< h_c mu l/k: below 1 the walls of a fracture are slower than the rock
  double fill = 0.0;   ///< h_c t/(S h_f): below 1 they do not fill the nodes beside them
  Point place;         ///< m
};

/// Share of the element size that the nodes at a straight wall take of the rock beside it: half of
/// the height of equilateral triangles.
constexpr double share_of_wall = 0.433;

/// What the depth depends on, region by region.
class Rock {
public:
  Rock(const Setup& setup, const seepage::Model& model) : model_(model), end_(setup.time.end) {
    const auto materials = material_of_regions(setup, model.mesh);
    for (Index r = 0; r < static_cast<Index>(materials.size()); ++r) {
      storage_.push_back(1.0 / model.biot_modulus(r) +
                         (has_motion(setup.model.physics)
                              ? deformation_storage(setup.material.at(materials[at(r)]))
                              : 0.0));
    }
  }

  /// Into triangle `t` along the unit vector `way`, through walls of the given exchange (m/(Pa s)).
  [[nodiscard]] Penetration into(Index t, const Point& way, double exchange) const {
    const Index region = model_.mesh.region[at(t)];
    const double k = dot(way, model_.rock[at(region)].permeability * way);
    const double mu = model_.fluid.viscosity;
    const double storage = storage_[at(region)];
    const double depth = std::sqrt(k * end_ / (mu * storage));
    const double size = mechanics::element_size(model_.mesh, t);
    return {depth / size,
            depth,
            size,
            exchange * mu * depth / k,
            exchange * end_ / (storage * share_of_wall * size),
            model_.mesh.triangle_centre(t)};
  }

private:
  /// alpha^2/E_oed, 1/Pa: rock that is pressed apart by its fluid and held at its sides.
  static double deformation_storage(const Material& material) {
    const double nu = std::min(material.solid.poisson_ratio, 0.5);
    const double alpha = material.biot_coefficient;
    return alpha * alpha * (1.0 + nu) * (1.0 - 2.0 * nu) /
           (material.solid.young_modulus * (1.0 - nu));
  }

  const seepage::Model& model_;
  double end_;                   // s
  std::vector<double> storage_;  // per region, 1/Pa
};

/// Tells which conditions move fluid at some time of the run.
class Drive {
public:
  Drive(const Setup& setup, const seepage::Model& model) : setup_(setup), model_(model) {}

  /// A rate that is not zero.
  [[nodiscard]] bool of_rate(const seepage::NodeCondition& condition) const {
    return differs(condition, 0.0, 0.0);
  }
  /// A pressure that is not the one of the rock at the start; `now` is that of the node, Pa.
  [[nodiscard]] bool of_pressure(const seepage::NodeCondition& condition, const Point& place,
                                 double now) const {
    constexpr double compression = 1e-12;  // of the fluid, that counts as none
    return differs(condition, setup_.initial.steady ? now : initial_pressure(setup_, model_, place),
                   compression * model_.fluid.bulk_modulus);
  }

private:
  [[nodiscard]] bool differs(const seepage::NodeCondition& condition, double start,
                             double least) const {
    constexpr double round_off = 1e-9;
    const Schedule& schedule = model_.conditions.schedule[at(condition.schedule)];
    const double end = setup_.time.end;
    for (double t = 0.0;; t = std::min(schedule.next_break(t), end)) {
      const double value = model_.conditions.value(condition, t);
      const double scale = std::max(std::abs(value), std::abs(start));
      if (std::abs(value - start) > std::max(least, round_off * scale)) {
        return true;
      }
      if (t >= end) {
        return false;
      }
    }
  }

  const Setup& setup_;
  const seepage::Model& model_;
};

/// Joints that are connected with a place where fluid comes into cracks, or goes out of them.
std::vector<Index> fed_joints(const seepage::Model& model, const Drive& drive) {
  std::vector<std::uint8_t> known(model.mesh.vertex.size(), 0);
  std::vector<Index> to_do;
  const auto reach = [&](Index v) {
    if (model.cracks.is_open(v) && known[at(v)] == 0) {
      known[at(v)] = 1;
      to_do.push_back(v);
    }
  };
  for (const seepage::NodeCondition& c : model.conditions.crack.rate) {
    if (drive.of_rate(c)) {
      reach(c.place);
    }
  }
  for (const seepage::NodeCondition& c : model.conditions.crack.pressure) {
    if (drive.of_pressure(c, model.mesh.vertex[at(c.place)],
                          model.state.crack_pressure[at(c.place)])) {
      reach(c.place);
    }
  }
  while (!to_do.empty()) {
    const Index v = to_do.back();
    to_do.pop_back();
    for (const Index j : model.mesh.vertex_joints.row(v)) {
      if (model.cracks.is_broken(j)) {
        reach(model.mesh.joint[at(j)].vertex[0]);
        reach(model.mesh.joint[at(j)].vertex[1]);
      }
    }
  }
  std::vector<Index> joints;
  for (const Index j : model.cracks.broken_joints()) {
    if (known[at(model.mesh.joint[at(j)].vertex[0])] != 0) {
      joints.push_back(j);
    }
  }
  return joints;
}

std::string depth_text(const std::string& where, const Penetration& least) {
  return fmt::format(
      "by the end of the run fluid gets sqrt(k t/(mu S)) = {:.2g} m into the rock {}, "
      "less than one element ({:.2g} m at ({:g}, {:g}))",
      least.depth, where, least.size, least.place.x, least.place.y);
}

/// Elements that resolve a depth: some of them lie within it.
std::string advice(const Penetration& least) {
  constexpr double within = 3.0;
  return fmt::format("elements of at most {:.2g} m there", least.depth / within);
}

std::vector<std::string> warn_of_fractures(const Setup& setup, const seepage::Model& model,
                                           const Rock& rock) {
  std::map<Index, Penetration> least;  // by fracture group
  for (const Index j : fed_joints(model, Drive(setup, model))) {
    const Index group = model.crack.group[at(j)];
    const mesh::Joint& joint = model.mesh.joint[at(j)];
    const Point along =
        (1.0 / model.mesh.joint_length(j)) *
        (model.mesh.vertex[at(joint.vertex[1])] - model.mesh.vertex[at(joint.vertex[0])]);
    for (const auto& side : joint.corner) {
      const Penetration here = rock.into(mesh::triangle_of(side[0]), clockwise(along),
                                         model.fracture[at(group)].exchange);
      if (here.walls >= 1.0 && here.ratio < least[group].ratio) {
        least[group] = here;
      }
    }
  }
  std::vector<std::string> warnings;
  const auto names = fracture_table_names(setup);
  for (const auto& [group, here] : least) {
    if (here.ratio >= 1.0) {
      continue;
    }
    const std::string path = "fracture." + names[at(group)];
    const std::string ruled =
        here.fill < 1.0 ? path + ".exchange sets what leaks off, not the permeability"
                        : "the size of the elements sets what leaks off, not the permeability, "
                          "and makes it too much";
    warnings.push_back(fmt::format("{}: {}. Where leak-off matters take {}, or a {}.exchange that "
                                   "makes the wall slower than the rock",
                                   depth_text("beside " + path, here), ruled, advice(here), path));
  }
  return warnings;
}

/// Keeps for `name` the least penetration into the triangle of a corner.
void take_least(const Rock& rock, const std::string& name, Index corner,
                std::map<std::string, Penetration>& least) {
  for (const Point way : {Point{1.0, 0.0}, Point{0.0, 1.0}}) {
    const Penetration here = rock.into(mesh::triangle_of(corner), way, 0.0);
    if (here.ratio < least[name].ratio) {
      least[name] = here;
    }
  }
}

void warn_of_sources(const Setup& setup, const seepage::Model& model, const Rock& rock,
                     std::vector<std::string>& warnings) {
  const Drive drive(setup, model);
  std::map<std::string, Penetration> least;
  for (const seepage::NodeCondition& c : model.conditions.pore.rate) {
    const std::string& name = model.conditions.name[at(c.condition)];
    if (name.starts_with("source.") && drive.of_rate(c)) {
      take_least(rock, name, c.place, least);
    }
  }
  for (const auto& [name, here] : least) {
    if (here.ratio < 1.0) {
      warnings.push_back(fmt::format("{}: the pressure there follows from the size of the "
                                     "elements. Take {}",
                                     depth_text("at " + name, here), advice(here)));
    }
  }
}

void warn_of_walls(const Setup& setup, const seepage::Model& model, const Rock& rock,
                   std::vector<std::string>& warnings) {
  const auto is_pressurised = [&](const std::string& name) {
    return std::any_of(setup.boundary.begin(), setup.boundary.end(), [&](const auto& entry) {
      return entry.second.pressurised && "boundary." + entry.first == name;
    });
  };
  const Drive drive(setup, model);
  std::map<std::string, Penetration> least;
  for (const seepage::NodeCondition& c : model.conditions.pore.pressure) {
    const std::string& name = model.conditions.name[at(c.condition)];
    if (is_pressurised(name) &&
        drive.of_pressure(c, model.mesh.place_of(c.place), model.state.pressure[at(c.place)])) {
      take_least(rock, name, c.place, least);
    }
  }
  for (const auto& [name, here] : least) {
    if (here.ratio < 1.0) {
      warnings.push_back(
          fmt::format("{}: how the pressure falls from the wall, and with it the pressure that "
                      "breaks the rock, follows from the size of the elements. Take {}, or on = "
                      "\"crack\" for a wall that lets nothing through",
                      depth_text("at " + name, here), advice(here)));
    }
  }
}

}  // namespace

std::vector<std::string> leak_off_warnings(const Setup& setup, const seepage::Model& model) {
  if (setup.time.scheme == Scheme::steady) {
    return {};
  }
  const Rock rock(setup, model);
  std::vector<std::string> warnings = warn_of_fractures(setup, model, rock);
  warn_of_sources(setup, model, rock, warnings);
  warn_of_walls(setup, model, rock, warnings);
  return warnings;
}

}  // namespace percolith::simulation
