// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/corner.hpp"

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

// Arrays of the simulator as numpy sees them: no copies, and read-only, because what is derived
// from them would not follow. As long as a view lives, so does what owns its numbers.
namespace percolith::python {

namespace nb = nanobind;

/// The docstring of an array: its shape and what the comment of the member says.
inline std::string shaped(const char* shape, const char* comment) {
  return std::string(shape) + ": " + comment;
}

template <class T>
using View = nb::ndarray<nb::numpy, const T>;

/// One value an element.
template <class T>
View<T> list_view(const std::vector<T>& values, nb::handle owner) {
  return View<T>(values.data(), {values.size()}, owner);
}
template <class T>
View<T> list_view(std::span<const T> values, nb::handle owner) {
  return View<T>(values.data(), {values.size()}, owner);
}

/// Values per corner slot as (blocks, 8, 3): corner k of triangle t at [t // 8, t % 8, k].
template <class T>
View<T> corner_view(std::span<const T> values, nb::handle owner) {
  constexpr auto width = static_cast<std::size_t>(block_width);
  const std::size_t blocks = values.size() / (3 * width);
  return View<T>(values.data(), {blocks, width, 3}, owner,
                 {static_cast<std::int64_t>(3 * width), 1, static_cast<std::int64_t>(width)});
}
inline View<double> corner_view(const std::vector<double>& values, nb::handle owner) {
  return corner_view(std::span<const double>(values), owner);
}

}  // namespace percolith::python
