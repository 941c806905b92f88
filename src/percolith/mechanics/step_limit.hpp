// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/model.hpp"

#include <limits>
#include <string>
#include <vector>

namespace percolith::mechanics {

/// Squares of frequencies that bound what one triangle adds to the motion of its corners, 1/s2, and
/// the rate of viscous decay, 1/s.
struct Frequencies {
  double triangle = 0.0;  ///< pores that cannot drain included
  double joints = 0.0;
  double contact = 0.0;
  double viscous = 0.0;
  double absorbing = 0.0;  ///< rate of decay by dashpots, 1/s
};

/// The largest stable step one mechanism allows, and where.
struct MotionLimit {
  std::string mechanism;  ///< "triangles", "joints", "contact", "viscosity", "absorbing boundary",
                          ///< "all together"
  double step = std::numeric_limits<double>::infinity();  ///< s
  Index triangle = mesh::none;
};

/// Frequencies of a triangle (theory.md section 12): the largest eigenvalue of its stiffness over
/// its own corner masses; twice the stiffness of the joints at a corner over its mass; the same for
/// a contact over the longest edge with `contact_penalty` p_n (Pa), whose slope is 6 p_n over the
/// height of the triangle.
[[nodiscard]] Frequencies frequencies(const Model& model, Index triangle, double contact_penalty);

/// Longest stable step of a mode of frequency square `square` that decays at rate `viscous`, where
/// viscous forces are those of the last velocities: dt^2 square + 2 dt viscous = 4.
[[nodiscard]] double stable_step(double square, double viscous);

/// Longest stable step of a triangle on which something that is no part of `f` acts besides, such
/// as the fluid in a crack, of frequency square `more` (1/s2).
[[nodiscard]] double stable_step(const Model& model, const Frequencies& f, double more);

/// Limits of the explicit step for each mechanism that is there, smallest first; the last entry
/// counts all together and is the one that holds. `contact_penalty` has one entry a triangle, Pa;
/// empty without contact. Joints that broke count as contact does, which took their place.
[[nodiscard]] std::vector<MotionLimit> step_limits(const Model& model,
                                                   std::span<const double> contact_penalty);

/// Raises the mass of triangles that allow less than `step` (s) alone until they allow it; gravity
/// keeps the true mass. Returns the mass added over the mass there was.
double scale_mass(Model& model, std::span<const double> contact_penalty, double step);

/// Gives every triangle the mass with which it is stable alone up to `step` (s), no more and no
/// less; gravity keeps the true mass. For motion that only looks for rest.
void even_masses(Model& model, std::span<const double> contact_penalty, double step);

}  // namespace percolith::mechanics
