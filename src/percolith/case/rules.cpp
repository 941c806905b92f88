// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/rules.hpp"

#include "percolith/case/applies.hpp"
#include "percolith/case/option_list.hpp"
#include "percolith/case/requirements.hpp"

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

bool Rules::is_known(const std::string& key, const std::vector<std::string>& others) const {
  return context_.problems.touch(key) ||
         std::any_of(others.begin(), others.end(),
                     [&](const std::string& other) { return context_.problems.touch(other); });
}

InputProblem Rules::located(const std::string& key, std::string reason, std::string allowed) const {
  Written written = context_.locations.nearest(key);
  return {std::move(written.location), key, std::move(written.value), std::move(reason),
          std::move(allowed)};
}

void Rules::fail(const std::string& key, const std::vector<std::string>& others, std::string reason,
                 std::string allowed) {
  if (!is_known(key, others)) {
    context_.problems.add(located(key, std::move(reason), std::move(allowed)));
  }
}

void Rules::fail_missing(const std::string& key, const std::vector<std::string>& others,
                         std::string reason, std::string allowed) {
  if (!is_known(key, others)) {
    context_.problems.add_missing(located(key, std::move(reason), std::move(allowed)));
  }
}

void check_rules(const simulation::Setup& setup, Context& context) {
  Rules rules(setup, context);
  check_physics(rules);
  check_applicability(rules);
  check_requirements(rules);
  check_model(rules);
  if (rules.has_motion()) {
    check_mechanics(rules);
    check_supports(rules);
  }
  if (rules.has_flow()) {
    check_conditions(rules);
    check_saturation(rules);
  }
  if (rules.is_coupled()) {
    check_coupling(rules);
  }
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
  const std::string holder = pattern.substr(0, pattern.find('.'));
  if (pattern.find('*') == std::string::npos) {
    names.emplace_back();
  } else if (holder == "material") {
    collect(setup.material);
  } else if (holder == "fracture") {
    collect(setup.fracture);
  } else if (holder == "boundary") {
    collect(setup.boundary);
  } else if (holder == "source") {
    collect(setup.source);
  } else if (holder == "body") {
    collect(setup.body);
  } else if (holder == "point_force") {
    collect(setup.point_force);
  } else if (holder == "excavation") {
    collect(setup.excavation);
  } else if (holder == "probe") {
    collect(setup.probe);
  }
  return names;
}

std::vector<std::string> keys_of(const std::vector<std::string>& patterns,
                                 const std::string& name) {
  std::vector<std::string> keys;
  keys.reserve(patterns.size());
  for (const std::string& pattern : patterns) {
    keys.push_back(with_name(pattern, name));
  }
  return keys;
}

}  // namespace

void check_applicability(Rules& rules) {
  for (const Applicability& rule : applicabilities()) {
    for (const std::string& name : names_of(rule.option, rules.setup())) {
      const std::string key = with_name(rule.option, name);
      if (!rules.given(key) || rule.holds(rules.setup(), name)) {
        continue;
      }
      rules.fail(key, keys_of(rule.needs, name), "has no effect here: it needs " + rule.condition);
    }
  }
}

void check_requirements(Rules& rules) {
  for (const Requirement& rule : requirements()) {
    for (const std::string& name : names_of(rule.option, rules.setup())) {
      const std::string key = with_name(rule.option, name);
      if (!rules.given(key) && rule.holds(rules.setup(), name)) {
        rules.fail_missing(key, keys_of(rule.needs, name),
                           "required but missing: " + help_of(rule.option));
      }
    }
  }
}

}  // namespace percolith::case_file
