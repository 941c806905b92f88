// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/number.hpp"
#include "percolith/simulation/setup.hpp"

#include <string>
#include <vector>

namespace percolith::case_file {

/// What the rules between options share: the setup as read, and what the user wrote.
class Rules {
public:
  Rules(const simulation::Setup& setup, Context& context) : setup_(setup), context_(context) {}

  [[nodiscard]] const simulation::Setup& setup() const { return setup_; }
  /// True where the user wrote this option, rightly or wrongly.
  [[nodiscard]] bool given(const std::string& key) const { return context_.locations.given(key); }
  /// Those of the options `names` of the table `path` that the user wrote, as dotted keys.
  [[nodiscard]] std::vector<std::string> given_of(const std::string& path,
                                                  const std::vector<std::string>& names) const;
  /// Reports a problem of `key`, unless it or one of the `others` has one already.
  void fail(const std::string& key, const std::vector<std::string>& others, std::string reason,
            std::string allowed = {});

private:
  const simulation::Setup& setup_;
  Context& context_;
};

/// Reports every contradiction between options. A rule is silent where one of the options it needs
/// has a problem of its own.
void check_rules(const simulation::Setup& setup, Context& context);

/// Options that have no effect because of others.
void check_applicability(Rules& rules);
/// Mesh, rocks and fractures.
void check_model(Rules& rules);
/// Boundary, source and initial conditions.
void check_conditions(Rules& rules);
/// Pressures of conditions below the cavitation pressure, and saturations that contradict them.
void check_saturation(Rules& rules);
/// Time stepping, output and probes.
void check_run(Rules& rules);

}  // namespace percolith::case_file
