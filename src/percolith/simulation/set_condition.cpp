// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/set_condition.hpp"

#include "percolith/core/error.hpp"
#include "percolith/seepage/model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace percolith::simulation {
namespace {

using mesh::Index;

[[noreturn]] void refuse(const std::string& path, const std::string& value, std::string reason,
                         std::string allowed) {
  throw InputError({{}, path, value, std::move(reason), std::move(allowed)});
}

bool presses(const ConditionAccess& access, const std::string& name) {
  return std::ranges::find(access.pressing, name) != access.pressing.end();
}

/// Paths of all conditions, by number.
std::vector<std::string> paths_of(const ConditionAccess& access) {
  std::vector<std::string> paths;
  if (access.model != nullptr) {
    const seepage::Conditions& given = access.model->conditions;
    for (std::size_t i = 0; i < given.name.size(); ++i) {
      paths.push_back(given.name[i] + "." + given.option[i]);
    }
  }
  return paths;
}

std::string name_in(const std::string& path) {
  return path.substr(0, path.rfind('.'));
}

Index number_of(const ConditionAccess& access, const std::string& path) {
  std::vector<std::string> paths = paths_of(access);
  const auto found = std::ranges::find(paths, path);
  const auto number = static_cast<Index>(found - paths.begin());
  const bool is_pressing = presses(access, name_in(path));
  if (found != paths.end() && !is_pressing) {
    return number;
  }
  std::erase_if(paths, [&](const std::string& p) { return presses(access, name_in(p)); });
  const std::string allowed = paths.empty() ? "this run has none that can be changed"
                                            : fmt::format("{}", fmt::join(paths, ", "));
  if (is_pressing) {
    refuse(path, "",
           "this condition presses on the rock as well, and cannot be changed while it "
           "waits",
           "a table of values over time in the case; " + allowed);
  }
  refuse(path, "", "no condition of the flow has this option", allowed);
}

/// A pressure below that of cavitation cannot be held.
void require_possible(const seepage::Model& model, Index number, const std::string& path,
                      double value) {
  if (!model.can_empty()) {
    return;
  }
  const seepage::Conditions& given = model.conditions;
  const auto check = [&](const std::vector<seepage::NodeCondition>& list) {
    for (const seepage::NodeCondition& c : list) {
      const double pressure = c.factor * value + c.offset;
      if (c.schedule == number && pressure < model.reference_pressure()) {
        refuse(path, fmt::format("{:g}", value),
               fmt::format("prescribes {:.6g} Pa, below the cavitation pressure", pressure),
               fmt::format("pressures of at least {:g} Pa", model.reference_pressure()));
      }
    }
  };
  for (const seepage::FieldConditions* field : {&given.pore, &given.crack}) {
    check(field->pressure);
    check(field->seepage_face);
  }
}

}  // namespace

void set_condition(const ConditionAccess& access, const std::string& path, double value) {
  const Index number = number_of(access, path);
  if (!std::isfinite(value)) {
    refuse(path, fmt::format("{:g}", value), "not a finite number", "a number in SI units");
  }
  require_possible(*access.model, number, path, value);
  access.model->conditions.schedule[at(number)] = Schedule::constant(value);
}

}  // namespace percolith::simulation
