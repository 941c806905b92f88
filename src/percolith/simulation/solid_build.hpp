// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/build.hpp"
#include "percolith/mechanics/dynamics.hpp"
#include "percolith/simulation/setup.hpp"

#include <functional>
#include <string>
#include <vector>

namespace percolith::simulation {

/// Regions that belong to bodies: per region of the mesh the number of its body in the order of the
/// tables, or `none`.
struct BodyRegions {
  std::vector<mesh::Index> body;
  std::vector<std::uint8_t> rigid;  ///< per region
};
[[nodiscard]] BodyRegions body_regions(const Setup& setup, const mesh::Mesh& mesh);

/// Materials, kinds and states of joints of a setup; the kinds are those of the materials and then
/// those of the fractures, in the order of their tables.
[[nodiscard]] mechanics::Ingredients solid_ingredients(const Setup& setup, const mesh::Mesh& mesh);

/// In-situ stress in the plane at a place, Pa.
[[nodiscard]] Tensor in_situ_stress(const InSitu& in_situ, const Point& place);
/// In-situ stress across the plane at a place, Pa.
[[nodiscard]] double in_situ_across(const InSitu& in_situ, const Point& place);

/// Stiffness and friction of contact, per triangle: where nothing is given as stiff across and
/// along as the joints are.
[[nodiscard]] mechanics::ContactProperties contact_properties(const Setup& setup,
                                                              const mechanics::Model& model);

/// Loads and supports of the boundary, body and point_force tables. Throws InputError for unknown
/// groups and contradicting supports.
[[nodiscard]] mechanics::LoadList solid_loads(const Setup& setup, const mechanics::Model& model);
[[nodiscard]] mechanics::SupportSet solid_supports(const Setup& setup, mechanics::Model& model);

/// A rock that is ready to move, and what was done to its mass.
struct SolidStart {
  mechanics::Dynamics dynamics;
  double added_mass = 0.0;  ///< by mass scaling, over the mass there was
};
/// Throws InputError, with the option path as key, for what does not fit together, bodies that
/// overlap at the start among it.
/// `prepare` is called with the rock before its fluid, loads and supports are there, once its
/// stress is set.
[[nodiscard]] SolidStart
build_solid(const Setup& setup, const mesh::GmshMesh& file,
            const std::function<void(mechanics::Model&)>& prepare = nullptr);

/// Names of the kinds of joints: of the material or fracture table they come from.
[[nodiscard]] std::vector<std::string> joint_kind_names(const Setup& setup);

}  // namespace percolith::simulation
