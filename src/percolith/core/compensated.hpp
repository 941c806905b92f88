// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/device.hpp"

namespace percolith {

/// A sum kept in two numbers: `value` rounded to double and `carry`, what rounding lost.
struct CompensatedSum {
  double value = 0.0;
  double carry = 0.0;
  [[nodiscard]] double total() const { return value + carry; }
};

/// Adds `term` and keeps the exact rounding error of the addition (Knuth's two-sum).
PERCOLITH_DEVICE void add_compensated(double& value, double& carry, double term) {
  const double sum = value + term;
  const double term_part = sum - value;
  const double error = (value - (sum - term_part)) + (term - term_part);
  value = sum;
  carry += error;
}

PERCOLITH_DEVICE CompensatedSum& operator+=(CompensatedSum& sum, double term) {
  add_compensated(sum.value, sum.carry, term);
  return sum;
}

}  // namespace percolith
