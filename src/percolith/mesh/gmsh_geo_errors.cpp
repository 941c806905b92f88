// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/gmsh_geo_errors.hpp"

#include "percolith/mesh/gmsh_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>

namespace percolith::mesh {
namespace {

/// The texts behind `Error   :` in gmsh's output, each once, without its summary.
std::vector<std::string> error_lines(const std::string& output) {
  std::vector<std::string> errors;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t colon = line.find(": ");
    if (!line.starts_with("Error") || colon == std::string::npos) {
      continue;
    }
    const std::string text = line.substr(colon + 2);
    if (text.starts_with("----") || text.starts_with("Mesh generation error summary")) {
      break;
    }
    if (std::find(errors.begin(), errors.end(), text) == errors.end()) {
      errors.push_back(text);
    }
  }
  return errors;
}

/// An error that names its place: `'model.geo', line 3: Unknown variable 'x'`.
struct PlacedError {
  FileLocation location;
  std::string text;
};

std::optional<PlacedError> placed_error(const std::string& error,
                                        const std::filesystem::path& geometry) {
  constexpr std::string_view mark = "', line ";
  const std::size_t end = error.find(mark);
  if (!error.starts_with('\'') || end == std::string::npos) {
    return std::nullopt;
  }
  const std::size_t digits = end + mark.size();
  const std::size_t colon = error.find(": ", digits);
  int line = 0;
  std::from_chars(error.data() + digits, error.data() + error.size(), line);
  if (colon == std::string::npos || line <= 0) {
    return std::nullopt;
  }
  std::string file = error.substr(1, end - 1);
  std::error_code ignored;
  if (std::filesystem::equivalent(file, geometry, ignored)) {
    file = geometry.string();
  }
  return PlacedError{{file, line, 0}, error.substr(colon + 2)};
}

}  // namespace

void throw_geo_errors(const ProgramResult& result, const std::filesystem::path& geometry) {
  const std::vector<std::string> errors = error_lines(result.output);
  if (errors.empty() && result.exit_code == 0) {
    return;
  }
  PlacedError first{{geometry.string()}, fmt::format("exit code {}", result.exit_code)};
  std::string more;
  if (!errors.empty()) {
    first.text = errors.front();
    for (const std::string& error : errors) {
      if (auto placed = placed_error(error, geometry)) {
        first = std::move(*placed);
        break;
      }
    }
    for (const std::string& error : errors) {
      more += error.ends_with(first.text) ? "" : "\n  gmsh: " + error;
    }
  }
  fail_mesh(first.location, fmt::format("gmsh cannot mesh the geometry: {}{}", first.text, more));
}

}  // namespace percolith::mesh
