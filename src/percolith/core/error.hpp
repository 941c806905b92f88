// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace percolith {

/// Exit codes of the program, one per family of errors.
enum class ExitCode : int { success = 0, input = 2, solver = 3, file = 4 };

/// Base of every error a user may see: a message that says what was wrong and what helps.
class Error : public std::runtime_error {
public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  [[nodiscard]] ExitCode exit_code() const { return code_; }

private:
  ExitCode code_;
};

/// Where in a text file something stands; line and column count from 1, 0 means unknown.
struct FileLocation {
  std::string file;
  int line = 0;
  int column = 0;
};

/// Something the user wrote is wrong. `key` is the dotted path of the option at fault
/// (`boundary.left.pressure`), empty when no option is; `value` is what was written, `reason` why
/// it cannot be, `allowed` what can. A room that knows no file leaves the location empty; the room
/// that read the file fills it in from the key.
struct InputProblem {
  FileLocation location;
  std::string key;
  std::string value;
  std::string reason;
  std::string allowed;
};

/// Formats a problem as `file:line:col: error: key = value: reason; allowed: ...`, leaving out
/// what is empty.
[[nodiscard]] std::string describe_problem(const InputProblem& problem);

/// Bad input: exit code 2.
class InputError : public Error {
public:
  explicit InputError(InputProblem problem)
      : Error(ExitCode::input, describe_problem(problem)), problem_(std::move(problem)) {}
  [[nodiscard]] const InputProblem& problem() const { return problem_; }

private:
  InputProblem problem_;
};

/// The computation cannot go on (no convergence, a value that is not a number): exit code 3.
class SolverError : public Error {
public:
  explicit SolverError(const std::string& message) : Error(ExitCode::solver, message) {}
};

/// A file cannot be read or written: exit code 4.
class FileError : public Error {
public:
  explicit FileError(const std::string& message) : Error(ExitCode::file, message) {}
};

}  // namespace percolith
