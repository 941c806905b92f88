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
template <class Real>
PERCOLITH_DEVICE void add_compensated(Real& value, Real& carry, Real term) {
  const Real sum = value + term;
  const Real term_part = sum - value;
  const Real error = (value - (sum - term_part)) + (term - term_part);
  value = sum;
  carry += error;
}

PERCOLITH_DEVICE CompensatedSum& operator+=(CompensatedSum& sum, double term) {
  add_compensated(sum.value, sum.carry, term);
  return sum;
}

}  // namespace percolith
