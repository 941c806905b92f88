// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace percolith::case_file {

/// A file of comma-separated values: names of the columns, then rows of as many cells.
struct CsvTable {
  struct Row {
    int line = 0;  ///< in the file, from 1
    std::vector<std::string> cells;
  };
  std::vector<std::string> columns;
  std::vector<Row> rows;
};

/// Reads a table. Cells may stand in double quotes; blanks around them, empty lines and lines that
/// begin with # are skipped. Throws InputError, with the line where there is one, for a file that
/// is missing or empty, an unclosed quote, and a row with more or fewer cells than columns.
[[nodiscard]] CsvTable read_csv(const std::filesystem::path& file);

}  // namespace percolith::case_file
