// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/error.hpp"

#include <fmt/format.h>

namespace percolith {

std::string describe_problem(const InputProblem& problem) {
  std::string text;
  const FileLocation& at = problem.location;
  if (!at.file.empty()) {
    text += at.file;
    if (at.line > 0) {
      text += fmt::format(":{}", at.line);
      if (at.column > 0) {
        text += fmt::format(":{}", at.column);
      }
    }
    text += ": ";
  }
  text += "error: ";
  if (!problem.key.empty()) {
    text += problem.key;
    if (!problem.value.empty()) {
      text += " = " + problem.value;
    }
    text += ": ";
  }
  text += problem.reason;
  if (!problem.allowed.empty()) {
    text += "; allowed: " + problem.allowed;
  }
  return text;
}

}  // namespace percolith
