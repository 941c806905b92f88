// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/cli/command_line.hpp"

#include "percolith/case/nearest.hpp"
#include "percolith/core/error.hpp"
#include "percolith/runner/version_text.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <sstream>

namespace percolith::cli {
namespace {

constexpr const char* footer =
    "Programs named percolith-NAME next to this one or on the PATH run as percolith NAME;\n"
    "percolith plot DIR draws the results of a run, percolith report DIR puts all of them into "
    "one\n"
    "page for a browser.\n"
    "\n"
    "Exit codes: 0 success, 2 bad input, 3 the solver cannot go on, 4 a file cannot be read or\n"
    "written, 130 or 143 stopped by a signal.\n"
    "\n"
    "Example: percolith new strip mine && percolith run mine/case.toml";

CLI::Option* add_overrides(CLI::App* command, std::vector<std::string>& overrides) {
  return command
      ->add_option("--set", overrides,
                   "Use this value in place of the case file's; may be repeated. An empty value "
                   "takes the option out.")
      ->type_name("PATH.TO.KEY=VALUE")
      ->allow_extra_args(false);
}

// The options of all commands and the parser that fills them.
struct Parser {
  CLI::App app{"Seepage in fractured porous rock; deformation and fracture of rock."};
  RunOptions run;
  CheckOptions check;
  SchemaOptions schema;
  NewOptions new_case;
  CLI::App* run_command = nullptr;
  CLI::App* check_command = nullptr;
  CLI::App* schema_command = nullptr;
  CLI::App* new_command = nullptr;

  Parser() {
    app.name("percolith");
    app.set_version_flag("--version", runner::version_text(),
                         "Print the version and how it was built");
    app.require_subcommand(1);
    app.footer(footer);
    add_run();
    add_check();
    add_schema();
    add_new();
  }

  void add_run() {
    run_command = app.add_subcommand("run", "Run a case and write its results");
    CLI::Option* case_file =
        run_command->add_option("CASE", run.case_file, "Case file (TOML)")->type_name("");
    CLI::Option* output =
        run_command
            ->add_option("--output", run.output,
                         "Folder for the results [<name of the case file>.results, here]")
            ->type_name("DIR");
    run_command->add_option("--threads", run.threads, "Number of threads [all processors]")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
    CLI::Option* overrides = add_overrides(run_command, run.overrides);
    CLI::Option* force =
        run_command->add_flag("--force", run.force, "Replace the results of an earlier run");
    run_command
        ->add_option("--resume", run.resume,
                     "In place of CASE: go on with the run in this folder from its last "
                     "checkpoint; its results become those of a run without interruption")
        ->type_name("DIR")
        ->excludes(case_file)
        ->excludes(output)
        ->excludes(overrides)
        ->excludes(force);
    run_command->add_flag("--quiet", run.quiet, "Print warnings and errors only");
    run_command->footer(
        "Example: percolith run case.toml --set time.end=\"3 hour\" --output three_hours");
  }

  void add_check() {
    check_command = app.add_subcommand(
        "check", "Check a case without running it: mesh, model, limits of the time step");
    check_command->add_option("CASE", check.case_file, "Case file (TOML)")
        ->required()
        ->type_name("");
    add_overrides(check_command, check.overrides);
    check_command->footer("Example: percolith check case.toml --set mesh.element_size=0.05");
  }

  void add_schema() {
    schema_command = app.add_subcommand("schema", "Print the JSON Schema of case files");
    schema_command->add_flag("--reference", schema.reference,
                             "Print the reference page of all options instead");
    schema_command->footer("Example: percolith schema > percolith.schema.json");
  }

  void add_new() {
    new_command = app.add_subcommand("new", "Copy a worked example to start from");
    new_command->add_option("EXAMPLE", new_case.example, "Name of the example; without it, a list")
        ->type_name("");
    new_command->add_option("DIR", new_case.folder, "New folder [the name of the example]")
        ->type_name("");
    new_command->footer("Example: percolith new six_fractures mine");
  }

  [[nodiscard]] Command chosen() const {
    if (run_command->parsed()) {
      if (!run.resume && run.case_file.empty()) {
        throw CLI::RequiredError("CASE");
      }
      return run;
    }
    if (check_command->parsed()) {
      return check;
    }
    if (schema_command->parsed()) {
      return schema;
    }
    return new_case;
  }

  // The command whose arguments were being read when an error came up.
  [[nodiscard]] const CLI::App& current() const {
    const std::vector<CLI::App*> commands = app.get_subcommands();
    return commands.empty() ? app : *commands.front();
  }

  [[nodiscard]] std::string help_command() const {
    return (&current() == &app ? "percolith" : "percolith " + current().get_name()) + " --help";
  }

  // What stands on the command line and belongs nowhere.
  [[nodiscard]] std::string unknown_argument() const {
    const std::vector<std::string> remaining = app.remaining(true);
    const auto option = std::find_if(remaining.begin(), remaining.end(),
                                     [](const std::string& word) { return word.starts_with('-'); });
    const std::string word = option == remaining.end() ? remaining.front() : *option;
    std::vector<std::string> known;
    for (const CLI::Option* candidate : current().get_options()) {
      known.push_back(candidate->get_name());
    }
    const std::vector<std::string_view> names(known.begin(), known.end());
    const std::string_view nearest = case_file::nearest_name(word.substr(0, word.find('=')), names);
    return "unknown argument " + word +
           (nearest.empty() ? "" : ", did you mean " + std::string(nearest) + "?");
  }
};

}  // namespace

Command parse_command_line(std::span<const std::string> arguments) {
  Parser parser;
  if (arguments.empty()) {
    throw InputError({{},
                      "",
                      "",
                      "no command given",
                      "run, check, schema, new, plot, report; see "
                      "percolith --help"});
  }
  std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
  try {
    parser.app.parse(std::move(reversed));
    return parser.chosen();
  } catch (const CLI::Success& success) {
    std::ostringstream text;
    parser.app.exit(success, text, text);
    return Answer{text.str()};
  } catch (const CLI::ExtrasError&) {
    throw InputError(
        {{}, "", "", parser.unknown_argument() + "; see " + parser.help_command(), ""});
  } catch (const CLI::ParseError& error) {
    throw InputError(
        {{}, "", "", std::string(error.what()) + "; see " + parser.help_command(), ""});
  }
}

}  // namespace percolith::cli
