// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/problems.hpp"
#include "percolith/core/error.hpp"

#include <exception>
#include <vector>

#include "modules.hpp"

namespace nb = nanobind;

namespace percolith::python {
namespace {

nb::object problem_of(const nb::module_& errors, const InputProblem& problem) {
  const auto text = [](const std::string& words) { return nb::str(words.data(), words.size()); };
  return errors.attr("Problem")(text(describe_problem(problem)), text(problem.location.file),
                                problem.location.line, problem.location.column, text(problem.key),
                                text(problem.value), text(problem.reason), text(problem.allowed));
}

nb::list problems_of(const nb::module_& errors, const Error& error) {
  nb::list problems;
  if (const auto* one = dynamic_cast<const InputError*>(&error)) {
    problems.append(problem_of(errors, one->problem()));
  } else if (const auto* several = dynamic_cast<const case_file::InputErrors*>(&error)) {
    for (const InputProblem& problem : several->problems()) {
      problems.append(problem_of(errors, problem));
    }
  }
  return problems;
}

/// Raises the exception of the package for an error of the simulator, with the same message.
void raise(const Error& error) {
  const nb::module_ errors = nb::module_::import_("percolith.errors");
  const char* message = error.what();
  switch (error.exit_code()) {
  case ExitCode::solver:
    PyErr_SetString(errors.attr("SolverError").ptr(), message);
    return;
  case ExitCode::file:
    PyErr_SetString(errors.attr("FileError").ptr(), message);
    return;
  case ExitCode::success:
  case ExitCode::input:
    break;
  }
  const nb::object kind = errors.attr("CaseError");
  const nb::object made = kind(nb::str(message), problems_of(errors, error));
  PyErr_SetObject(kind.ptr(), made.ptr());
}

}  // namespace

void bind_errors(nb::module_& /*module*/) {
  nb::register_exception_translator([](const std::exception_ptr& thrown, void* /*payload*/) {
    try {
      std::rethrow_exception(thrown);
    } catch (const Error& error) {
      raise(error);
    }
  });
}

}  // namespace percolith::python
