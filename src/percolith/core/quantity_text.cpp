// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/quantity_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace percolith {

std::string pressure_text(double pressure) {
  struct Prefix {
    const char* unit;
    double factor;
  };
  // What three digits round up to a thousand has the next unit.
  constexpr double full = 0.9995;
  for (const Prefix& prefix : std::array<Prefix, 3>{{{"GPa", 1e9}, {"MPa", 1e6}, {"kPa", 1e3}}}) {
    if (std::abs(pressure) >= full * prefix.factor) {
      return fmt::format("{:.3g} {}", pressure / prefix.factor, prefix.unit);
    }
  }
  return fmt::format("{:.3g} Pa", pressure);
}

}  // namespace percolith
