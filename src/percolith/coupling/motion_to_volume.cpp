// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/coupling/motion_to_volume.hpp"

#include "percolith/mechanics/pressed_faces.hpp"

namespace percolith::coupling {

void take_volumes(CoupledModel& model, Execution& execution) {
  mechanics::Model& rock = model.rock.model();
  model.water.swelling = rock.pores.growth;
  mechanics::measure_faces(rock, execution);
  const auto start = std::chrono::steady_clock::now();
  std::vector<seepage::CrackOpening> openings;
  openings.reserve(rock.pressed.size());
  for (const mechanics::PressedFaces& faces : rock.pressed) {
    openings.push_back({faces.joint, faces.opening, faces.compression});
  }
  seepage::open_cracks(model.water, openings);
  execution.book("crack openings", start);
}

}  // namespace percolith::coupling
