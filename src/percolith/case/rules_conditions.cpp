// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/nearest.hpp"
#include "percolith/case/rules.hpp"

#include <fmt/format.h>

namespace percolith::case_file {

namespace {

using simulation::Domain;

/// Reports more than one of the options, and none of them where one is `required`.
void check_one_of(Rules& rules, const std::string& path, const std::vector<std::string>& names,
                  Need need) {
  const std::vector<std::string_view> views(names.begin(), names.end());
  const std::vector<std::string> keys = rules.given_of(path, names);
  if (keys.empty() && need == Need::required) {
    rules.fail_missing(path, {"model.physics"}, "one option is missing", "one of " + listed(views));
  }
  for (std::size_t i = 1; i < keys.size(); ++i) {
    report_contradiction(rules, keys[i], keys[0], views);
  }
}

void check_head(Rules& rules, const std::string& key) {
  if (rules.given(key) && rules.setup().model.gravity == 0.0) {
    rules.fail(key, {"model.gravity"}, "needs gravity, which is 0", "model.gravity > 0");
  }
}

void check_fractures_exist(Rules& rules, const std::string& key) {
  if (rules.setup().fracture.empty()) {
    rules.fail(key, {"fracture"}, "the case has no fracture", "a table [fracture.NAME]");
  }
}

void check_fracture_names(Rules& rules, const std::string& key,
                          const std::vector<std::string>& names) {
  std::vector<std::string_view> known;
  for (const auto& [name, group] : rules.setup().fracture) {
    known.push_back(name);
  }
  for (const std::string& name : names) {
    if (rules.setup().fracture.count(name) == 0) {
      const std::string_view nearest = nearest_name(name, known);
      rules.fail(key, {"fracture"},
                 nearest.empty() ? fmt::format("there is no table [fracture.{}]", name)
                                 : fmt::format("there is no table [fracture.{}]; the nearest valid "
                                               "name is \"{}\"",
                                               name, nearest),
                 known.empty() ? "a table [fracture.NAME] of that name" : listed(known));
    }
  }
}

void check_boundary(Rules& rules) {
  for (const auto& [name, condition] : rules.setup().boundary) {
    const std::string path = "boundary." + name;
    check_one_of(rules, path, {"pressure", "head", "flux", "seepage_face"},
                 rules.has_motion() ? Need::optional : Need::required);
    check_head(rules, path + ".head");
    if (condition.on == Domain::crack && !rules.setup().new_cracks) {
      check_fractures_exist(rules, path + ".on");
    }
  }
}

void check_sources(Rules& rules) {
  for (const auto& [name, source] : rules.setup().source) {
    const std::string path = "source." + name;
    check_one_of(rules, path, {"point", "fractures"}, Need::required);
    check_one_of(rules, path, {"rate", "pressure"}, Need::required);
    if (rules.given(path + ".fractures") && source.fractures.empty()) {
      rules.fail(path + ".fractures", {}, "names no fracture", "at least one name");
    }
    check_fracture_names(rules, path + ".fractures", source.fractures);
    if (source.point && source.into == Domain::crack) {
      check_fractures_exist(rules, path + ".into");
    }
    if (source.point && source.pressure && source.into == Domain::matrix) {
      rules.fail(path + ".pressure", {path + ".into"},
                 "a pressure cannot be held at a point of the matrix", "rate, or into = \"crack\"");
    }
  }
}

void check_initial(Rules& rules) {
  check_one_of(rules, "initial", {"pressure", "head", "water_table"}, Need::optional);
  check_head(rules, "initial.head");
  check_head(rules, "initial.water_table");
  for (const char* const key : {"initial.crack_pressure", "initial.crack_saturation"}) {
    if (rules.given(key)) {
      check_fractures_exist(rules, key);
    }
  }
}

}  // namespace

void report_contradiction(Rules& rules, const std::string& key, const std::string& other,
                          const std::vector<std::string_view>& names) {
  const std::string other_name = other.substr(other.rfind('.') + 1);
  rules.fail(key, {}, fmt::format("contradicts \"{}\", which is given too", other_name),
             "only one of " + listed(names));
}

void check_conditions(Rules& rules) {
  check_boundary(rules);
  check_sources(rules);
  check_initial(rules);
}

}  // namespace percolith::case_file
