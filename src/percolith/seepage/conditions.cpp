// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/conditions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace percolith::seepage {

double last_moment(double end) {
  return end - 4.0 * std::numeric_limits<double>::epsilon() * std::abs(end);
}

double Conditions::next_break(double t) const {
  double earliest = std::numeric_limits<double>::infinity();
  for (const Schedule& s : schedule) {
    earliest = std::min(earliest, s.next_break(t));
  }
  return earliest;
}

}  // namespace percolith::seepage
