// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/cli/check_text.hpp"
#include "percolith/cli/commands.hpp"
#include "percolith/cli/console.hpp"
#include "percolith/core/error.hpp"
#include "percolith/runner/load_model.hpp"

#include <fmt/format.h>

namespace percolith::cli {

int check(const CheckOptions& options) {
  const runner::LoadedModel model = runner::load_model({options.case_file, {}, options.overrides});
  const simulation::CheckReport report = model.simulation.check();
  const simulation::Setup& setup = model.read_case.setup;
  std::string text = fmt::format("Case {}\n", options.case_file.string());
  if (!setup.title.empty()) {
    text += fmt::format("  {}\n", setup.title);
  }
  print(text + check_text(report, setup.time));
  for (const std::string& warning : model.read_case.warnings) {
    print_line_to_stderr(warning);
  }
  for (const std::string& warning : report.warnings) {
    print_line_to_stderr("warning: " + warning);
  }
  print("The case can be run.\n");
  return static_cast<int>(ExitCode::success);
}

}  // namespace percolith::cli
