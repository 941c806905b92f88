// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/coupling/pressure_to_force.hpp"

namespace percolith::coupling {

void apply_pressures(CoupledModel& model) {
  mechanics::Model& rock = model.rock.model();
  rock.pores.pressure = model.water.state.pressure;
  for (mechanics::PressedFaces& faces : rock.pressed) {
    const auto& ends = rock.mesh.joint[at(faces.joint)].vertex;
    for (std::size_t end = 0; end < 2; ++end) {
      faces.pressure[end] = model.water.state.crack_pressure[at(ends[end])];
    }
  }
}

}  // namespace percolith::coupling
