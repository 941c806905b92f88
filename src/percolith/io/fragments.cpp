// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/fragments.hpp"

#include "percolith/io/csv.hpp"
#include "percolith/io/field_names.hpp"

#include <string_view>

namespace percolith::io {

std::string fragments_header() {
  CsvLine line;
  for (const char* column : {names::time, "fragment", "triangles", "area_m2", "x_m", "y_m",
                             "velocity_x_m_per_s", "velocity_y_m_per_s"}) {
    line.add(std::string_view(column));
  }
  return line.text();
}

std::string fragment_lines(double time, const std::vector<simulation::FragmentRow>& rows) {
  std::string lines;
  for (const simulation::FragmentRow& row : rows) {
    CsvLine line;
    line.add(time).add(std::int64_t{row.number}).add(row.triangles).add(row.area);
    line.add(row.centre.x).add(row.centre.y).add(row.velocity.x).add(row.velocity.y);
    lines += line.text();
  }
  return lines;
}

}  // namespace percolith::io
