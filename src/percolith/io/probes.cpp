// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/probes.hpp"

#include "percolith/io/csv.hpp"
#include "percolith/io/field_names.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace percolith::io {

std::string probe_header(const simulation::ProbeSample& sample) {
  CsvLine line;
  line.add(std::string_view(names::time)).add(std::string_view("x_m")).add(std::string_view("y_m"));
  for (const std::string& column : sample.columns) {
    line.add(std::string_view(column));
  }
  return line.text();
}

std::string probe_lines(double time, const simulation::ProbeSample& sample) {
  std::string lines;
  for (const simulation::ProbeRow& row : sample.rows) {
    if (row.values.size() != sample.columns.size()) {
      throw std::invalid_argument(fmt::format("probe {}: {} values for {} columns", sample.name,
                                              row.values.size(), sample.columns.size()));
    }
    CsvLine line;
    line.add(time).add(row.place.x).add(row.place.y);
    for (const double value : row.values) {
      if (std::isnan(value)) {
        line.add_empty();
      } else {
        line.add(value);
      }
    }
    lines += line.text();
  }
  return lines;
}

}  // namespace percolith::io
