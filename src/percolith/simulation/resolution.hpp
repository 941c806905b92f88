// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/model.hpp"
#include "percolith/simulation/crack_starts.hpp"

#include <limits>
#include <optional>
#include <span>
#include <string>

namespace percolith::simulation {

/// The bonded joint whose elements are largest against its cohesive length l = E' G_I/f_t^2
/// (theory.md section 10).
struct Resolution {
  double ratio = std::numeric_limits<double>::infinity();  ///< cohesive length over element size
  double length = 0.0;                                     ///< cohesive length, m
  double size = 0.0;                                       ///< of the elements, m
  mesh::Index joint = mesh::none;
  Point place;       ///< m
  std::string what;  ///< what starts cracks there; "" in the whole of the rock
};

/// Elements that have to lie within the cohesive length.
inline constexpr double resolved = 3.0;

/// The coarsest one in all of the rock; absent where no joint may break in tension.
[[nodiscard]] std::optional<Resolution> coarsest(const mechanics::Model& model);
/// The coarsest of the joints that touch places where cracks start; absent where none does.
[[nodiscard]] std::optional<Resolution> coarsest_at(const mechanics::Model& model,
                                                    std::span<const CrackStart> starts);

/// Distance (m) from the places where cracks start to the nearest joint whose elements do not
/// resolve its cohesive length; infinite where all do.
[[nodiscard]] double resolved_distance(const mechanics::Model& model,
                                       std::span<const CrackStart> starts);

/// What a user should know of elements that do not resolve the cohesive length: those where cracks
/// start, or the coarsest of all where nothing tells that they start anywhere. "" where they do.
[[nodiscard]] std::string resolution_warning(const mechanics::Model& model,
                                             std::span<const CrackStart> starts);

}  // namespace percolith::simulation
