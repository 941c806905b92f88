// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/error.hpp"

#include <string>
#include <vector>

namespace percolith::case_file {

/// Everything that is wrong in a case file, one line each: exit code 2.
class InputErrors : public Error {
public:
  explicit InputErrors(std::vector<InputProblem> problems);
  [[nodiscard]] const std::vector<InputProblem>& problems() const { return problems_; }

private:
  std::vector<InputProblem> problems_;
};

/// Collects problems, so that one reading of a file reports all of them.
class Problems {
public:
  void add(InputProblem problem) { problems_.push_back(std::move(problem)); }
  /// True where a problem stands at this key, at one that it holds, or at one that holds it.
  [[nodiscard]] bool touch(const std::string& key) const;
  /// Throws InputErrors, in the order of the file, where there are any.
  void throw_if_any();

private:
  std::vector<InputProblem> problems_;
};

}  // namespace percolith::case_file
