// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/case.hpp"

#include "percolith/case/defaults.hpp"
#include "percolith/case/describe.hpp"
#include "percolith/case/overrides.hpp"
#include "percolith/case/physics.hpp"
#include "percolith/case/plausibility.hpp"
#include "percolith/case/reader.hpp"
#include "percolith/case/rules.hpp"
#include "percolith/case/toml_parser.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <system_error>

namespace percolith::case_file {

namespace {

/// A file of another format cannot be judged further, so its other problems are not looked for.
void check_format(const Node& root) {
  const Node* node = root.table()->find("format");
  const auto* format = node != nullptr ? std::get_if<std::int64_t>(&node->value) : nullptr;
  if (format == nullptr || *format == current_format) {
    return;
  }
  const bool newer = *format > current_format;
  const std::string reason =
      newer ? fmt::format("this file needs a newer version of Percolith, which reads format {}",
                          *format)
            : std::string("there is no such format");
  throw InputErrors(
      {{node->location, "format", to_text(*node), reason, std::to_string(current_format)}});
}

Node parse(std::string_view text, const std::string& file) {
  try {
    Node root = parse_toml(text, file);
    root.location = {file, 0, 0};
    root.key_location = root.location;
    return root;
  } catch (const InputError& error) {
    throw InputErrors({error.problem()});
  }
}

}  // namespace

Case read_case(const std::filesystem::path& file, std::span<const std::string> overrides) {
  std::error_code failure;
  if (std::filesystem::is_directory(file, failure)) {
    throw FileError(fmt::format("cannot read the case file {}: it is a directory", file.string()));
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw FileError(fmt::format("cannot read the case file {}: {}", file.string(),
                                std::filesystem::exists(file, failure) ? "it cannot be opened"
                                                                       : "no such file"));
  }
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  return read_case_text(text, file, overrides);
}

Case read_case_text(std::string_view text, const std::filesystem::path& file,
                    std::span<const std::string> overrides, std::span<const Rename> renames) {
  Units units;
  return read_case_text(text, file, overrides, renames, units);
}

Case read_case_text(std::string_view text, const std::filesystem::path& file,
                    std::span<const std::string> overrides, std::span<const Rename> renames,
                    Units& units) {
  Node root = parse(text, file.string());
  Problems problems;
  Case result;
  result.directory = file.parent_path();
  result.locations = KeyLocations({file.string(), 0, 0});
  apply_overrides(root, overrides, problems);
  check_format(root);
  result.warnings = apply_renames(root, renames, problems);
  Context context{units, result.directory, problems, result.locations,
                  find_physics(root, problems)};
  Reader reader(root, {}, context);
  describe(reader, result.setup);
  reader.finish();
  if (!context.physics.empty()) {  // else nothing is known that the rules could judge by
    choose_defaults(result.setup, result.locations);
    check_rules(result.setup, context);
  }
  suggest_tables(root, problems);
  problems.throw_if_any();
  const std::vector<std::string> doubts = plausibility_warnings(result.setup, result.locations);
  result.warnings.insert(result.warnings.end(), doubts.begin(), doubts.end());
  return result;
}

InputError locate(const InputError& error, const Case& known) {
  InputProblem problem = error.problem();
  if (!problem.location.file.empty()) {
    return error;
  }
  const Written written = known.locations.nearest(problem.key);
  problem.location = written.location;
  if (problem.value.empty()) {
    problem.value = written.value;
  }
  return InputError(std::move(problem));
}

}  // namespace percolith::case_file
