// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/node.hpp"
#include "percolith/case/option.hpp"
#include "percolith/time/schedule.hpp"

#include <string>

namespace percolith::case_file {

/// A list of numbers whose default unit stands beside it; null where it is not given.
struct PendingList {
  const Node* node = nullptr;
};

/// A value over time as the user writes it: a table, or columns of a CSV file.
struct ScheduleTable {
  Quantity quantity;  ///< the option it stands for
  PendingList times;
  PendingList values;
  std::string file;
  std::string time_column;
  std::string value_column;
  std::string time_unit;
  std::string value_unit;
  Interpolation interpolation = Interpolation::linear;
};

template <class V>
void describe(V& option, ScheduleTable& m) {
  option(m.times, Quantity{"times", "s", finite, Need::optional,
                           "Times of the entries, strictly increasing."});
  option(m.values,
         Quantity{"values", m.quantity.unit, m.quantity.bounds, Need::optional,
                  "Values at these times; the first and the last hold before and after."});
  option(m.file, Text{"file", Need::optional,
                      "A CSV file that holds times and values; relative to the case file."});
  option(m.time_column, Text{"time_column", Need::optional,
                             "Name of its column of times; not needed in a file of two columns."});
  option(m.value_column,
         Text{"value_column", Need::optional,
              "Name of its column of values; not needed in a file of two columns."});
  option(m.time_unit, Text{"time_unit", Need::optional,
                           "Unit of times written as plain numbers; s when absent."});
  option(m.value_unit, Text{"value_unit", Need::optional,
                            "Unit of values written as plain numbers; SI when absent."});
  option(m.interpolation,
         Choice<Interpolation>{
             "interpolation",
             {{Interpolation::linear, "linear"}, {Interpolation::step, "step"}},
             "Between two entries: a straight line, or the value of the earlier one."});
}

}  // namespace percolith::case_file
