// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/runner/derived_values.hpp"

#include <fmt/format.h>

#include <variant>

namespace percolith::runner {

std::vector<case_file::DerivedValue> derived_values(const simulation::CheckReport& report,
                                                    const std::string& version) {
  std::vector<case_file::DerivedValue> derived = {
      {"version of percolith", version, ""},
      {"triangles", fmt::format("{}", report.triangles), ""}};
  if (report.pore_nodes > 0) {
    derived.push_back({"pore nodes", fmt::format("{}", report.pore_nodes), ""});
    derived.push_back({"crack nodes", fmt::format("{}", report.crack_nodes), ""});
  }
  derived.push_back({"smallest edge", fmt::format("{}", report.smallest_edge), "m"});
  for (const auto& [name, value] : report.mechanics) {
    derived.push_back(
        {name, std::visit([](auto number) { return fmt::format("{}", number); }, value), ""});
  }
  for (const simulation::StepLimit& limit : report.limits) {
    derived.push_back(
        {"limit of the explicit step by " + limit.mechanism, fmt::format("{}", limit.step), "s"});
  }
  return derived;
}

}  // namespace percolith::runner
