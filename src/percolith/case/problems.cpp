// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/problems.hpp"

#include <algorithm>
#include <tuple>

namespace percolith::case_file {

namespace {

std::string all_lines(const std::vector<InputProblem>& problems) {
  std::string text;
  for (const InputProblem& problem : problems) {
    text += text.empty() ? "" : "\n";
    text += describe_problem(problem);
  }
  return text;
}

}  // namespace

InputErrors::InputErrors(std::vector<InputProblem> problems)
    : Error(ExitCode::input, all_lines(problems)), problems_(std::move(problems)) {}

void Problems::add_missing(InputProblem problem) {
  missing_.insert(problem.key);
  add(std::move(problem));
}

std::vector<InputProblem> Problems::take_missing(const std::string& path) {
  const auto kept =
      std::stable_partition(problems_.begin(), problems_.end(), [&](const InputProblem& problem) {
        return missing_.count(problem.key) == 0 ||
               (problem.key != path && problem.key.rfind(path + ".", 0) != 0);
      });
  std::vector<InputProblem> taken(kept, problems_.end());
  problems_.erase(kept, problems_.end());
  return taken;
}

bool Problems::touch(const std::string& key) const {
  return std::any_of(problems_.begin(), problems_.end(), [&](const InputProblem& problem) {
    return problem.key == key || problem.key.rfind(key + ".", 0) == 0 ||
           key.rfind(problem.key + ".", 0) == 0;
  });
}

void Problems::throw_if_any() {
  if (problems_.empty()) {
    return;
  }
  std::stable_sort(problems_.begin(), problems_.end(),
                   [](const InputProblem& a, const InputProblem& b) {
                     return std::tie(a.location.line, a.location.column) <
                            std::tie(b.location.line, b.location.column);
                   });
  throw InputErrors(std::move(problems_));
}

}  // namespace percolith::case_file
