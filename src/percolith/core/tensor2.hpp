// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/vec2.hpp"

namespace percolith {

/// A symmetric tensor of the plane.
template <class T>
struct SymmetricTensor2 {
  T xx{};
  T yy{};
  T xy{};
  friend bool operator==(const SymmetricTensor2&, const SymmetricTensor2&) = default;
};

/// a . v
template <class T>
PERCOLITH_DEVICE Vec2<T> operator*(const SymmetricTensor2<T>& a, Vec2<T> v) {
  return {a.xx * v.x + a.xy * v.y, a.xy * v.x + a.yy * v.y};
}

/// True where both principal values are positive.
[[nodiscard]] inline bool is_positive_definite(const SymmetricTensor2<double>& a) {
  return a.xx > 0 && a.xx * a.yy - a.xy * a.xy > 0;
}

using Tensor = SymmetricTensor2<double>;

}  // namespace percolith
