// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/rules.hpp"
#include "percolith/case/supports.hpp"

#include <algorithm>

namespace percolith::case_file {

namespace {

using simulation::BoundaryCondition;

/// A support and those that cannot stand beside it on one boundary.
struct Conflict {
  std::string_view name;
  std::vector<std::string_view> others;
};

/// What moves a boundary leaves no room for what else would move or hold it the same way, and
/// tractions across the edges are told by one option alone.
std::vector<Conflict> conflicts() {
  return {
      {"fixed",
       {"roller", "displacement_x", "displacement_y", "velocity_x", "velocity_y", "traction_x",
        "traction_y", "normal_pressure", "pressurised", "in_situ", "absorbing"}},
      {"roller",
       {"displacement_x", "displacement_y", "velocity_x", "velocity_y", "normal_pressure",
        "pressurised", "absorbing"}},
      {"displacement_x", {"velocity_x", "traction_x", "absorbing"}},
      {"displacement_y", {"velocity_y", "traction_y", "absorbing"}},
      {"velocity_x", {"traction_x", "absorbing"}},
      {"velocity_y", {"traction_y", "absorbing"}},
      {"normal_pressure", {"traction_x", "traction_y", "pressurised", "in_situ"}},
      {"pressurised", {"traction_x", "traction_y", "in_situ"}},
  };
}

bool acts(const BoundaryCondition& condition, std::string_view name) {
  return std::any_of(supports().begin(), supports().end(), [&](const Support& support) {
    return support.name == name && support.acts(condition);
  });
}

void check_conflicts(Rules& rules, const std::string& path, const BoundaryCondition& condition) {
  for (const Conflict& conflict : conflicts()) {
    for (const std::string_view other : conflict.others) {
      if (acts(condition, conflict.name) && acts(condition, other)) {
        report_contradiction(rules, join_key(path, other), join_key(path, conflict.name),
                             {conflict.name, other});
      }
    }
  }
}

void check_any(Rules& rules, const std::string& path, const BoundaryCondition& condition) {
  std::vector<std::string_view> names;
  bool any = false;
  for (const Support& support : supports()) {
    if (rules.has_flow() || support.name != "pressurised") {
      names.push_back(support.name);
    }
    any = any || support.acts(condition);
  }
  const bool flows = rules.has_flow() && (condition.pressure || condition.head || condition.flux ||
                                          condition.seepage_face);
  if (!any && !flows) {
    rules.fail(path, {"model.physics"},
               rules.has_flow() ? "a support, a load or a condition of the flow is missing"
                                : "a support or a load is missing",
               "one or more of " + listed(names));
  }
}

}  // namespace

void check_supports(Rules& rules) {
  for (const auto& [name, condition] : rules.setup().boundary) {
    const std::string path = "boundary." + name;
    check_any(rules, path, condition);
    check_conflicts(rules, path, condition);
    if (condition.in_situ && !rules.setup().in_situ) {
      rules.fail(path + ".in_situ", {"in_situ"}, "the case has no in-situ stress",
                 "a table [in_situ]");
    }
  }
}

}  // namespace percolith::case_file
