// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/rules.hpp"

#include "percolith/case/applies.hpp"

#include <algorithm>

namespace percolith::case_file {

std::vector<std::string> Rules::given_of(const std::string& path,
                                         const std::vector<std::string>& names) const {
  std::vector<std::string> keys;
  for (const std::string& name : names) {
    const std::string key = join_key(path, name);
    if (given(key)) {
      keys.push_back(key);
    }
  }
  return keys;
}

void Rules::fail(const std::string& key, const std::vector<std::string>& others, std::string reason,
                 std::string allowed) {
  const bool is_known = std::any_of(others.begin(), others.end(), [&](const std::string& other) {
    return context_.problems.touch(other);
  });
  if (is_known || context_.problems.touch(key)) {
    return;
  }
  Written written = context_.locations.nearest(key);
  context_.problems.add({std::move(written.location), key, std::move(written.value),
                         std::move(reason), std::move(allowed)});
}

void check_rules(const simulation::Setup& setup, Context& context) {
  Rules rules(setup, context);
  check_applicability(rules);
  check_model(rules);
  check_conditions(rules);
  check_saturation(rules);
  check_run(rules);
}

namespace {

/// The names that stand for the `*` of a pattern; one empty name where it has none.
std::vector<std::string> names_of(const std::string& pattern, const simulation::Setup& setup) {
  std::vector<std::string> names;
  const auto collect = [&](const auto& tables) {
    for (const auto& [name, table] : tables) {
      names.push_back(name);
    }
  };
  if (pattern.rfind("boundary.", 0) == 0) {
    collect(setup.boundary);
  } else if (pattern.rfind("source.", 0) == 0) {
    collect(setup.source);
  } else if (pattern.rfind("probe.", 0) == 0) {
    collect(setup.probe);
  } else {
    names.emplace_back();
  }
  return names;
}

}  // namespace

void check_applicability(Rules& rules) {
  for (const Applicability& rule : applicabilities()) {
    for (const std::string& name : names_of(rule.option, rules.setup())) {
      const std::string key = with_name(rule.option, name);
      if (!rules.given(key) || rule.holds(rules.setup(), name)) {
        continue;
      }
      std::vector<std::string> needs;
      for (const std::string& need : rule.needs) {
        needs.push_back(with_name(need, name));
      }
      rules.fail(key, needs, "has no effect here: it needs " + rule.condition);
    }
  }
}

}  // namespace percolith::case_file
