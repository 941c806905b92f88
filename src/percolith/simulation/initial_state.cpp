// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/error.hpp"
#include "percolith/seepage/set_state.hpp"
#include "percolith/simulation/build_model.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace percolith::simulation {
namespace {

using Fluid = seepage::FluidState<double>;

/// Pressure that the initial table gives at a place, Pa, and the option it comes from.
struct GivenPressure {
  double value = 0.0;
  const char* key = "initial.pressure";
};

GivenPressure pressure_at(const Setup& setup, const seepage::Model& model, const Point& p) {
  const double weight = setup.fluid.density * setup.model.gravity;
  if (setup.initial.head) {
    return {weight * (*setup.initial.head - (p.y - setup.model.head_datum)), "initial.head"};
  }
  if (setup.initial.water_table) {
    return {weight * (*setup.initial.water_table - p.y), "initial.water_table"};
  }
  return {setup.initial.pressure.value_or(std::max(0.0, model.reference_pressure()))};
}

/// Pressure and saturation at a place: above a water table the rock is at the cavitation pressure
/// and holds what the initial saturation says; elsewhere a full node has the given pressure.
Fluid fluid_at(const Setup& setup, const seepage::Model& model, const Point& p,
               GivenPressure pressure, double saturation, const char* saturation_key) {
  const double reference = model.reference_pressure();
  if (!model.can_empty()) {
    return {pressure.value, 1.0};
  }
  const bool dry_side = setup.initial.water_table && pressure.value < reference;
  if (dry_side) {
    return {reference, saturation};
  }
  if (pressure.value < reference) {
    throw InputError({{},
                      pressure.key,
                      "",
                      fmt::format("gives {:.6g} Pa at ({:g}, {:g}), below the cavitation pressure "
                                  "of {:.6g} Pa",
                                  pressure.value, p.x, p.y, reference),
                      "pressures not below fluid.cavitation_pressure, or initial.water_table"});
  }
  if (saturation < 1.0 && pressure.value > reference && !setup.initial.water_table) {
    throw InputError({{},
                      saturation_key,
                      fmt::format("{:g}", saturation),
                      fmt::format("partly empty rock stays at the cavitation pressure of {:.6g} "
                                  "Pa, but the initial pressure is {:.6g} Pa",
                                  reference, pressure.value),
                      "saturation 1, or an initial pressure equal to fluid.cavitation_pressure"});
  }
  return {pressure.value, pressure.value > reference ? 1.0 : saturation};
}

void apply_prescribed(seepage::Model& model) {
  const double reference = model.reference_pressure();
  for (const seepage::NodeCondition& c : model.conditions.pore.pressure) {
    const auto node = model.pore_nodes.leader(c.place);
    const double target = model.state.storage[static_cast<std::size_t>(node)] *
                          (model.conditions.value(c, 0.0) - reference);
    set_pore_content(model, node, {target, 0.0});
  }
  for (const seepage::NodeCondition& c : model.conditions.crack.pressure) {
    if (model.cracks.is_open(c.place)) {
      const double target =
          model.crack_storage(c.place) * (model.conditions.value(c, 0.0) - reference);
      set_crack_content(model, c.place, {target, 0.0});
    }
  }
}

}  // namespace

double initial_pressure(const Setup& setup, const seepage::Model& model, const Point& place) {
  return std::max(pressure_at(setup, model, place).value, model.reference_pressure());
}

void set_initial_state(const Setup& setup, seepage::Model& model) {
  seepage::set_pores(model, [&](const Point& p) {
    return fluid_at(setup, model, p, pressure_at(setup, model, p), setup.initial.saturation,
                    "initial.saturation");
  });
  const Initial& initial = setup.initial;
  seepage::set_cracks(model, [&](const Point& p) {
    const GivenPressure pressure =
        initial.crack_pressure ? GivenPressure{*initial.crack_pressure, "initial.crack_pressure"}
                               : pressure_at(setup, model, p);
    return fluid_at(setup, model, p, pressure,
                    initial.crack_saturation.value_or(initial.saturation),
                    initial.crack_saturation ? "initial.crack_saturation" : "initial.saturation");
  });
  // Rock that moves starts in equilibrium with the fluid it holds, before a well presses it.
  if (setup.model.physics != Physics::coupled) {
    apply_prescribed(model);
  }
}

}  // namespace percolith::simulation
