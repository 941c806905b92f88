// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/history.hpp"

#include "percolith/io/csv.hpp"
#include "percolith/io/field_names.hpp"

namespace percolith::io {
namespace {

void add_flow_names(CsvLine& line, const simulation::HistoryRow& row) {
  for (const char* column :
       {"minimum_pressure_Pa", "maximum_pressure_Pa", "minimum_crack_pressure_Pa",
        "maximum_crack_pressure_Pa", "minimum_saturation", "in_m2", "out_m2", "stored_m2",
        "in_place_m2", "error_m2", "relative_error"}) {
    line.add(std::string_view(column));
  }
  for (const auto& [condition, rate] : row.rate) {
    line.add(std::string_view(condition + "_m2_per_s"));
  }
}

void add_flow(CsvLine& line, const simulation::HistoryRow& row) {
  line.add(row.minimum_pressure).add(row.maximum_pressure);
  for (const auto& pressure : {row.minimum_crack_pressure, row.maximum_crack_pressure}) {
    pressure ? line.add(*pressure) : line.add_empty();
  }
  const simulation::MassBalance& balance = row.balance;
  line.add(row.minimum_saturation).add(balance.in).add(balance.out).add(balance.stored);
  line.add(balance.in_place).add(balance.error).add(balance.relative_error);
  for (const auto& [condition, rate] : row.rate) {
    line.add(rate);
  }
}

}  // namespace

std::string history_header(const simulation::HistoryRow& row) {
  CsvLine line;
  for (const char* column : {names::time, "step", "step_size_s"}) {
    line.add(std::string_view(column));
  }
  if (row.has_flow) {
    add_flow_names(line, row);
  }
  for (const auto& [name, value] : row.mechanics) {
    line.add(std::string_view(name));
  }
  return line.text();
}

std::string history_line(const simulation::HistoryRow& row) {
  CsvLine line;
  line.add(row.time).add(row.step).add(row.step_size);
  if (row.has_flow) {
    add_flow(line, row);
  }
  for (const auto& [name, value] : row.mechanics) {
    line.add(value);
  }
  return line.text();
}

}  // namespace percolith::io
