// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/device.hpp"

namespace percolith {

/// A vector of the plane; `T` is `double` or a vector of SIMD lanes.
template <class T>
struct Vec2 {
  T x{};
  T y{};

  PERCOLITH_DEVICE friend Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  PERCOLITH_DEVICE friend Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  PERCOLITH_DEVICE friend Vec2 operator*(T s, Vec2 a) { return {s * a.x, s * a.y}; }
  friend bool operator==(const Vec2&, const Vec2&) = default;
};

/// Scalar product a.b.
template <class T>
PERCOLITH_DEVICE T dot(Vec2<T> a, Vec2<T> b) {
  return a.x * b.x + a.y * b.y;
}

/// Out-of-plane component of a x b: twice the signed area of the triangle they span.
template <class T>
PERCOLITH_DEVICE T cross(Vec2<T> a, Vec2<T> b) {
  return a.x * b.y - a.y * b.x;
}

/// `a` turned clockwise by a right angle: the outward normal, times length, of an edge `a` that
/// runs counter-clockwise round its triangle.
template <class T>
PERCOLITH_DEVICE Vec2<T> clockwise(Vec2<T> a) {
  return {a.y, -a.x};
}

using Point = Vec2<double>;

}  // namespace percolith
