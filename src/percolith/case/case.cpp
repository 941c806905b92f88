// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/case.hpp"

#include "percolith/case/defaults.hpp"
#include "percolith/case/describe.hpp"
#include "percolith/case/overrides.hpp"
#include "percolith/case/path.hpp"
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

/// The physics that the case asks for, known before its options are read.
std::string_view physics_of_case(const Node& root) {
  const Node* node = find_at(root, {"model", "physics"});
  if (node == nullptr) {
    return "seepage";
  }
  for (const std::string_view physics : {"seepage", "mechanics", "coupled"}) {
    if (node->text() != nullptr && *node->text() == physics) {
      return physics;
    }
  }
  return {};
}

/// What a rock of solid grains has is a range; beyond it the equations still hold.
void warn_of_biot(Case& known) {
  for (const auto& [name, material] : known.setup.material) {
    const double alpha = material.biot_coefficient;
    if (alpha < material.rock.porosity || alpha > 1.0) {
      const std::string key = "material." + name + ".biot_coefficient";
      known.warnings.push_back(fmt::format(
          "{}: warning: {} = {:g} is outside of the range from the porosity, {:g}, to 1 that a "
          "rock of solid grains has",
          to_text(known.locations.nearest(key).location), key, alpha, material.rock.porosity));
    }
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
  Context context{units, result.directory, problems, result.locations, physics_of_case(root)};
  Reader reader(root, {}, context);
  describe(reader, result.setup);
  reader.finish();
  choose_defaults(result.setup, result.locations);
  check_rules(result.setup, context);
  problems.throw_if_any();
  if (result.setup.model.physics == simulation::Physics::coupled) {
    warn_of_biot(result);
  }
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
