// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/steady_suction.hpp"

#include "percolith/seepage/steady_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace percolith::simulation {
namespace {

using mesh::Index;
using seepage::NodeCondition;

/// Whether a source or flux lets fluid in at time 0.
bool has_inflow(const seepage::Conditions& conditions) {
  const auto is_inflow = [&](const NodeCondition& c) { return conditions.value(c, 0.0) > 0.0; };
  return std::any_of(conditions.pore.rate.begin(), conditions.pore.rate.end(), is_inflow) ||
         std::any_of(conditions.crack.rate.begin(), conditions.crack.rate.end(), is_inflow);
}

/// Highest elevation to which a prescribed pressure lifts water of `weight` (N/m3), m. Faces that
/// only let fluid out lift none.
double highest_level(const seepage::Model& model, double weight) {
  const seepage::Conditions& conditions = model.conditions;
  double highest = -std::numeric_limits<double>::infinity();
  const auto raise = [&](const NodeCondition& c, const Point& place) {
    highest = std::max(highest, conditions.value(c, 0.0) / weight + place.y);
  };
  for (const NodeCondition& c : conditions.pore.pressure) {
    raise(c, model.mesh.place_of(c.place));
  }
  for (const NodeCondition& c : conditions.crack.pressure) {
    raise(c, model.mesh.vertex[at(c.place)]);
  }
  return highest;
}

}  // namespace

std::optional<std::string> steady_suction_warning(const seepage::Model& model) {
  const double weight = model.fluid.density * model.gravity;
  if (!model.can_empty() || weight == 0.0 || has_inflow(model.conditions)) {
    return std::nullopt;
  }
  const auto [lowest, top] =
      std::minmax_element(model.mesh.vertex.begin(), model.mesh.vertex.end(),
                          [](const Point& a, const Point& b) { return a.y < b.y; });
  const double level = highest_level(model, weight);
  // Up there the pressure of water that stands at the level has fallen to the cavitation pressure.
  const double wet = level - model.reference_pressure() / weight;
  if (!(top->y > wet + 1e-9 * (top->y - lowest->y))) {
    return std::nullopt;
  }
  return fmt::format("the rock reaches up to ({:g}, {:g}), and no condition lifts water above y = "
                     "{:g} m: the rock would drain there, and the steady run will stop. {}",
                     top->x, top->y, level, seepage::ways_out_of_suction);
}

}  // namespace percolith::simulation
