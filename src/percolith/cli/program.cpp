// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/cli/program.hpp"

#include "percolith/cli/command_line.hpp"
#include "percolith/cli/commands.hpp"
#include "percolith/cli/console.hpp"
#include "percolith/cli/external_command.hpp"
#include "percolith/core/error.hpp"

#include <exception>
#include <new>
#include <variant>

namespace percolith::cli {
namespace {

constexpr int unexpected_failure = 1;

struct Dispatch {
  int operator()(const RunOptions& options) const {
    return options.resume ? resume(options) : run(options);
  }
  int operator()(const CheckOptions& options) const { return check(options); }
  int operator()(const SchemaOptions& options) const { return schema(options); }
  int operator()(const NewOptions& options) const { return copy_example(options); }
  int operator()(const Answer& answer) const {
    print(answer.text);
    return static_cast<int>(ExitCode::success);
  }
};

int dispatch(std::span<const std::string> arguments) {
  if (!arguments.empty() && is_external_command(arguments.front())) {
    return run_external_command(arguments);
  }
  return std::visit(Dispatch{}, parse_command_line(arguments));
}

}  // namespace

int run_program(std::span<const std::string> arguments) noexcept {
  try {
    return dispatch(arguments);
  } catch (const Error& error) {
    print_error(error);
    return static_cast<int>(error.exit_code());
  } catch (const std::bad_alloc&) {
    print_error("not enough memory for this model; use a coarser mesh, fewer outputs, or a machine "
                "with more memory");
    return static_cast<int>(ExitCode::solver);
  } catch (const std::exception& error) {
    print_error(std::string("unexpected: ") + error.what() +
                "; please report this with the case file");
  }
  return unexpected_failure;
}

}  // namespace percolith::cli
