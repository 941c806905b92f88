// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/error.hpp"

#include <set>
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
  /// Adds that something required is missing.
  void add_missing(InputProblem problem);
  /// Takes out what add_missing has added of the table `path`.
  [[nodiscard]] std::vector<InputProblem> take_missing(const std::string& path);
  /// True where a problem stands at this key, at one that it holds, or at one that holds it.
  [[nodiscard]] bool touch(const std::string& key) const;
  /// Throws InputErrors, in the order of the file, where there are any.
  void throw_if_any();

private:
  std::vector<InputProblem> problems_;
  std::set<std::string> missing_;  ///< keys of required options
};

}  // namespace percolith::case_file
