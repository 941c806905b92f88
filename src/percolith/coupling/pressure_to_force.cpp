// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/coupling/pressure_to_force.hpp"

namespace percolith::coupling {

void press_by(mechanics::Model& rock, const seepage::Model& water) {
  for (mechanics::PressedFaces& faces : rock.pressed) {
    const auto& ends = rock.mesh.joint[at(faces.joint)].vertex;
    for (std::size_t end = 0; end < 2; ++end) {
      faces.pressure[end] = water.state.crack_pressure[at(ends[end])];
    }
  }
}

void apply_pressures(CoupledModel& model) {
  model.rock.model().pores.pressure = model.water.state.pressure;
  press_by(model.rock.model(), model.water);
}

}  // namespace percolith::coupling
