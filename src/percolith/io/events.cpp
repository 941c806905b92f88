// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/events.hpp"

#include "percolith/io/csv.hpp"
#include "percolith/io/field_names.hpp"

#include <string_view>

namespace percolith::io {
namespace {

std::string_view mode_name(simulation::BreakMode mode) {
  switch (mode) {
  case simulation::BreakMode::tensile:
    return "tensile";
  case simulation::BreakMode::shear:
    return "shear";
  case simulation::BreakMode::mixed:
    break;
  }
  return "mixed";
}

}  // namespace

std::string events_header() {
  CsvLine line;
  for (const char* column : {names::time, "step", "x_m", "y_m", "mode", "length_m",
                             "released_energy_J_per_m", "magnitude", "material"}) {
    line.add(std::string_view(column));
  }
  return line.text();
}

std::string event_lines(const std::vector<simulation::BreakEvent>& events) {
  std::string lines;
  for (const simulation::BreakEvent& event : events) {
    CsvLine line;
    line.add(event.time).add(event.step).add(event.place.x).add(event.place.y);
    line.add(mode_name(event.mode)).add(event.length).add(event.released_energy);
    line.add(event.magnitude).add(std::string_view(event.material));
    lines += line.text();
  }
  return lines;
}

}  // namespace percolith::io
