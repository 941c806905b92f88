// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/csv.hpp"

#include "percolith/case/path.hpp"
#include "percolith/core/error.hpp"

#include <fmt/format.h>

#include <fstream>
#include <string_view>
#include <system_error>

namespace percolith::case_file {

namespace {

[[noreturn]] void fail(const std::filesystem::path& file, int line, std::string reason) {
  throw InputError(InputProblem{{file.string(), line, 0}, {}, {}, std::move(reason), {}});
}

std::vector<std::string> split(std::string_view text, const std::filesystem::path& file, int line) {
  std::vector<std::string> cells;
  std::string cell;
  bool inside_quotes = false;
  bool was_quoted = false;
  const auto finish = [&] {
    cells.push_back(was_quoted ? cell : trimmed(cell));
    cell.clear();
    was_quoted = false;
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char letter = text[i];
    if (inside_quotes && letter == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      cell += '"';
      ++i;
    } else if (letter == '"' && (inside_quotes || trimmed(cell).empty())) {
      inside_quotes = !inside_quotes;
      cell = was_quoted ? cell : "";
      was_quoted = true;
    } else if (letter == ',' && !inside_quotes) {
      finish();
    } else if (!was_quoted || inside_quotes) {
      cell += letter;
    }
  }
  if (inside_quotes) {
    fail(file, line, "a double quote is not closed on its line");
  }
  finish();
  return cells;
}

}  // namespace

CsvTable read_csv(const std::filesystem::path& file) {
  std::error_code failure;
  if (!std::filesystem::is_regular_file(file, failure)) {
    fail(file, 0, "no such file");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    fail(file, 0, "the file cannot be opened");
  }
  CsvTable table;
  std::string text;
  for (int line = 1; std::getline(stream, text); ++line) {
    if (line == 1 && text.rfind("\xEF\xBB\xBF", 0) == 0) {
      text.erase(0, 3);
    }
    const std::string content = trimmed(text);
    if (content.empty() || content.front() == '#') {
      continue;
    }
    std::vector<std::string> cells = split(content, file, line);
    if (table.columns.empty()) {
      table.columns = std::move(cells);
    } else if (cells.size() != table.columns.size()) {
      fail(file, line,
           fmt::format("{} cells in a row of a table with {} columns", cells.size(),
                       table.columns.size()));
    } else {
      table.rows.push_back({line, std::move(cells)});
    }
  }
  if (table.rows.empty()) {
    fail(file, 0, "the file has no row below its column names");
  }
  return table;
}

}  // namespace percolith::case_file
