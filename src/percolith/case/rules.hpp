// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/number.hpp"
#include "percolith/simulation/setup.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace percolith::case_file {

/// What the rules between options share: the setup as read, and what the user wrote.
class Rules {
public:
  Rules(const simulation::Setup& setup, Context& context) : setup_(setup), context_(context) {}

  [[nodiscard]] const simulation::Setup& setup() const { return setup_; }
  [[nodiscard]] bool has_flow() const { return simulation::has_flow(setup_.model.physics); }
  [[nodiscard]] bool has_motion() const { return simulation::has_motion(setup_.model.physics); }
  [[nodiscard]] bool is_coupled() const { return has_flow() && has_motion(); }
  /// True where the user wrote this option, rightly or wrongly.
  [[nodiscard]] bool given(const std::string& key) const { return context_.locations.given(key); }
  /// Those of the options `names` of the table `path` that the user wrote, as dotted keys.
  [[nodiscard]] std::vector<std::string> given_of(const std::string& path,
                                                  const std::vector<std::string>& names) const;
  /// Reports a problem of `key`, unless it or one of the `others` has one already.
  void fail(const std::string& key, const std::vector<std::string>& others, std::string reason,
            std::string allowed = {});
  /// As fail, where something required is missing.
  void fail_missing(const std::string& key, const std::vector<std::string>& others,
                    std::string reason, std::string allowed = {});

private:
  /// True where `key` or one of the `others` has a problem already.
  [[nodiscard]] bool is_known(const std::string& key, const std::vector<std::string>& others) const;
  /// A problem of `key` with the place and the value that the user wrote.
  [[nodiscard]] InputProblem located(const std::string& key, std::string reason,
                                     std::string allowed) const;

  const simulation::Setup& setup_;
  Context& context_;
};

/// Names of physical groups: at least one, none empty, none in two tables of the same kind.
class GroupNames {
public:
  explicit GroupNames(Rules& rules) : rules_(rules) {}

  /// The `names` that the option `key` gives.
  void add(const std::string& key, const std::vector<std::string>& names);

private:
  Rules& rules_;
  std::map<std::string, std::string> owner_;
};

/// Reports that `key` was given together with `other`, an option of the same table.
void report_contradiction(Rules& rules, const std::string& key, const std::string& other,
                          const std::vector<std::string_view>& names);

/// Reports every contradiction between options. A rule is silent where one of the options it needs
/// has a problem of its own.
void check_rules(const simulation::Setup& setup, Context& context);

/// The scheme of motion.
void check_physics(Rules& rules);
/// Options that have no effect because of others.
void check_applicability(Rules& rules);
/// Options that are missing where others make them required.
void check_requirements(Rules& rules);
/// Mesh, rocks and fractures.
void check_model(Rules& rules);
/// Boundary, source and initial conditions.
void check_conditions(Rules& rules);
/// Layers, bodies, forces, in-situ stress, excavations and damping.
void check_mechanics(Rules& rules);
/// Supports and loads of boundaries in mechanics.
void check_supports(Rules& rules);
/// Pressures of conditions below the cavitation pressure, and saturations that contradict them.
void check_saturation(Rules& rules);
/// What only coupled physics has.
void check_coupling(Rules& rules);
/// Time stepping, output and probes.
void check_run(Rules& rules);

}  // namespace percolith::case_file
