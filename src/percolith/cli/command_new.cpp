// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/case.hpp"
#include "percolith/case/nearest.hpp"
#include "percolith/cli/commands.hpp"
#include "percolith/cli/console.hpp"
#include "percolith/cli/examples_folder.hpp"
#include "percolith/core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace percolith::cli {
namespace {

void print_examples(const std::vector<Example>& examples) {
  std::size_t width = 0;
  for (const Example& example : examples) {
    width = std::max(width, example.name.size());
  }
  std::string text;
  for (const Example& example : examples) {
    const std::string title = case_file::read_case(example.folder / "case.toml").setup.title;
    text += fmt::format("{:<{}}  {}\n", example.name, width, title);
  }
  print(text + "\nCopy one with: percolith new EXAMPLE DIR\n");
}

[[noreturn]] void refuse(const std::string& name, const std::vector<Example>& examples) {
  std::vector<std::string_view> names;
  std::string allowed;
  for (const Example& example : examples) {
    names.push_back(example.name);
    allowed += (allowed.empty() ? "" : ", ") + example.name;
  }
  std::string reason = "no such example";
  if (const std::string_view nearest = case_file::nearest_name(name, names); !nearest.empty()) {
    reason += ", did you mean " + std::string(nearest) + "?";
  }
  throw InputError({{}, "EXAMPLE", name, reason, allowed});
}

}  // namespace

int copy_example(const NewOptions& options) {
  const std::vector<Example> examples = list_examples(examples_folder());
  if (!options.example) {
    print_examples(examples);
    return static_cast<int>(ExitCode::success);
  }
  const auto example = std::find_if(examples.begin(), examples.end(), [&](const Example& known) {
    return known.name == *options.example;
  });
  if (example == examples.end()) {
    refuse(*options.example, examples);
  }
  const std::filesystem::path target = options.folder.value_or(example->name);
  copy_folder(example->folder, target);
  const std::string file = (target / "case.toml").string();
  print(fmt::format("Copied {} to {}. Next:\n  percolith check {}\n  percolith run {}\n",
                    example->name, target.string(), file, file));
  return static_cast<int>(ExitCode::success);
}

}  // namespace percolith::cli
