// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/joint_forces.hpp"
#include "percolith/mechanics/loads.hpp"
#include "percolith/mechanics/model.hpp"

namespace percolith::mechanics {

/// Takes triangles out at the present time: they carry nothing and stand still from now on, their
/// joints are gone; `removed` is 1 for them, per triangle. Returns the forces they gave to the
/// corners of the rest, which fade over `duration` (s), and the walls they leave, on which nothing
/// presses yet. What they held of energy counts as absorbed.
[[nodiscard]] FadingSupport remove_triangles(Model& model, const JointTable& table,
                                             std::span<const Index> triangles,
                                             std::span<const std::uint8_t> removed,
                                             double duration);

}  // namespace percolith::mechanics
