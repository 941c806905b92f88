// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/set_pressure.hpp"

#include "percolith/core/error.hpp"
#include "percolith/seepage/content.hpp"
#include "percolith/seepage/model.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace percolith::simulation {
namespace {

using mesh::Index;

[[noreturn]] void refuse(double value, const Point& place, std::string reason,
                         std::string allowed) {
  throw InputError({{},
                    "pressure",
                    fmt::format("{:g} at ({:g}, {:g})", value, place.x, place.y),
                    std::move(reason),
                    std::move(allowed)});
}

seepage::Model& model_of(const FluidAccess& fluid) {
  if (fluid.model == nullptr) {
    throw InputError({{},
                      "pressure",
                      "",
                      "this run takes no pressures now",
                      "runs with flow; quasi-static ones before their first step"});
  }
  return *fluid.model;
}

void require_count(std::size_t given, Index wanted, const char* of) {
  if (given != at(wanted)) {
    throw InputError({{},
                      "pressure",
                      "",
                      fmt::format("there are {} values", given),
                      fmt::format("one for each of the {} {}", wanted, of)});
  }
}

void require_possible(const seepage::Model& model, double value, const Point& place) {
  if (!std::isfinite(value)) {
    refuse(value, place, "not a finite number", "pressures in Pa");
  }
  if (model.can_empty() && value < model.reference_pressure()) {
    refuse(value, place, "below the cavitation pressure",
           fmt::format("at least {:g} Pa", model.reference_pressure()));
  }
}

/// Calls `write`, which is no step: the balance counts from the fluid there is then.
template <class Write>
void without_account(const FluidAccess& fluid, const Write& write) {
  const Execution serial(Backend::serial);
  const double before = seepage::fluid_in_place(*fluid.model, serial);
  write();
  *fluid.in_place_at_start += seepage::fluid_in_place(*fluid.model, serial) - before;
}

void require_pores(const seepage::Model& model, std::span<const double> pressure) {
  const mesh::Mesh& mesh = model.mesh;
  require_count(pressure.size(), mesh.corners(), "corner slots");
  for (Index t = 0; t < mesh.triangles(); ++t) {
    for (Index k = 0; k < 3; ++k) {
      const Index c = mesh::corner_of(t, k);
      const Point& place = mesh.place_of(c);
      require_possible(model, pressure[at(c)], place);
      if (pressure[at(c)] != pressure[at(model.pore_nodes.leader(c))]) {
        refuse(pressure[at(c)], place, "corners that share a pore node differ",
               "one pressure for each pore node");
      }
    }
  }
}

void require_cracks(const seepage::Model& model, std::span<const double> pressure) {
  require_count(pressure.size(), model.mesh.vertices(), "vertices");
  for (const Index v : model.cracks.open_nodes()) {
    require_possible(model, pressure[at(v)], model.mesh.vertex[at(v)]);
  }
}

/// Whether a node has the pressure that it had before.
bool keeps(const PressureChange& change, std::size_t i) {
  return !change.former.empty() && change.former[i] == change.pressure[i];
}

void fill_pores(seepage::Model& model, const PressureChange& change) {
  for (const Index node : model.pore_nodes.nodes(model.mesh)) {
    const auto i = at(node);
    if (!keeps(change, i)) {
      const seepage::FluidState<double> full{change.pressure[i], 1.0};
      seepage::set_pore_content(
          model, node,
          {seepage::excess_of(full, model.state.growth[i], model.state.storage[i],
                              model.state.void_volume[i], model.reference_pressure()),
           0.0});
    }
  }
}

void fill_cracks(seepage::Model& model, const PressureChange& change) {
  for (const Index v : model.cracks.open_nodes()) {
    if (!keeps(change, at(v))) {
      const seepage::FluidState<double> full{change.pressure[at(v)], 1.0};
      seepage::set_crack_content(
          model, v,
          {seepage::excess_of(full, 0.0, model.crack_storage(v), model.crack.void_volume[at(v)],
                              model.reference_pressure()),
           0.0});
    }
  }
}

}  // namespace

void set_pore_pressure(const FluidAccess& fluid, std::span<const double> pressure) {
  seepage::Model& model = model_of(fluid);
  require_pores(model, pressure);
  without_account(fluid, [&] { fill_pores(model, {pressure, {}}); });
}

void set_crack_pressure(const FluidAccess& fluid, std::span<const double> pressure) {
  seepage::Model& model = model_of(fluid);
  require_cracks(model, pressure);
  without_account(fluid, [&] { fill_cracks(model, {pressure, {}}); });
}

void change_pressures(const FluidAccess& fluid, const PressureChange& pores,
                      const PressureChange& cracks) {
  seepage::Model& model = model_of(fluid);
  require_pores(model, pores.pressure);
  require_cracks(model, cracks.pressure);
  without_account(fluid, [&] {
    fill_pores(model, pores);
    fill_cracks(model, cracks);
  });
}

PressureMemory pressure_memory(const FluidAccess& fluid) {
  seepage::State& state = model_of(fluid).state;
  return {state.pressure, state.crack_pressure};
}

}  // namespace percolith::simulation
