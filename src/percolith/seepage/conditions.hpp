// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/corner.hpp"
#include "percolith/time/schedule.hpp"

#include <string>
#include <vector>

namespace percolith::seepage {

using mesh::Index;

/// A condition at one place: a corner for the pores, a vertex for the cracks. Its value at time t
/// is `factor * schedule(t) + offset`: a pressure (Pa) or a rate into the node (m2/s).
struct NodeCondition {
  Index place = 0;
  Index schedule = 0;
  Index condition = 0;  ///< whose account the fluid goes to
  double factor = 1.0;
  double offset = 0.0;
};

/// The conditions of one pressure field.
struct FieldConditions {
  std::vector<NodeCondition> pressure;      ///< prescribed
  std::vector<NodeCondition> rate;          ///< prescribed inflow
  std::vector<NodeCondition> seepage_face;  ///< outside pressure; fluid may only leave
};

/// The last moment of a step that ends at `end` (s): a condition that jumps then acts in the next
/// step only. Some units in the last place before the end, because time plus step is rounded.
[[nodiscard]] double last_moment(double end);

/// All boundary conditions and sources, by place. No node carries two prescribed pressures.
struct Conditions {
  std::vector<Schedule> schedule;
  std::vector<std::string> name;    ///< option path of each condition (`boundary.left`)
  std::vector<std::string> option;  ///< the option there whose value each takes (`pressure`)
  FieldConditions pore;             ///< places are corners; the condition acts on their node
  FieldConditions crack;            ///< places are vertices

  [[nodiscard]] double value(const NodeCondition& c, double t) const {
    return c.factor * schedule[static_cast<std::size_t>(c.schedule)].at(t) + c.offset;
  }
  /// First time after `t` at which any schedule breaks.
  [[nodiscard]] double next_break(double t) const;
};

}  // namespace percolith::seepage
