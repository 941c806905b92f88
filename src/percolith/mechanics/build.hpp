// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/model.hpp"

#include <array>

namespace percolith::mechanics {

/// Penalty p_f of the joints over E of the softer side where none is given.
inline constexpr double default_penalty = 20.0;

/// What a model is built from.
struct Ingredients {
  material::Plane plane = material::Plane::strain;
  double gravity = 0.0;                 ///< m/s2, along -y
  std::vector<SolidMaterial> material;  ///< `stiffness` is filled in by `make_model`
  std::vector<Index> region_material;   ///< per region of the mesh: index of `material`
  std::vector<JointKind> kind;          ///< kinds of joints, at least one
  std::vector<Index> joint_kind;        ///< per joint
  std::vector<JointState> joint_state;
  std::vector<double> joint_factor;  ///< per joint, on strengths; empty: all 1
  Damping damping;
};

/// Edge of the equilateral triangle with the area of triangle `t`: its element size h, m.
[[nodiscard]] double element_size(const mesh::Mesh& mesh, Index t);

/// E' of the softer side of a joint, Pa.
[[nodiscard]] double softer_modulus(const Model& model, Index joint);

/// Builds the rock at rest in its undeformed place, without loads and supports.
[[nodiscard]] Model make_model(mesh::Mesh mesh, Ingredients ingredients);

/// Makes room for in-situ stress, zero where there was none.
void make_room_for_stress(Model& model);

/// In-situ stress of the triangles, Pa, given at places of the undeformed rock: triangles take the
/// value at their centre, joints carry the traction that keeps the start in equilibrium.
template <class Stress>
void set_initial_stress(Model& model, const Stress& stress_at);

/// Lets closed joints start from the in-situ tractions of their faces, as far as friction bears
/// them.
void start_closed_joints(Model& model);

/// Prepares a joint to be given up or to be closed: it carries nothing as a bonded joint from now
/// on, and its memory is forgotten.
void switch_off(Model& model, Index joint);

/// Sets the force (N/m) of a joint on its side 0 at both ends; side 1 has the opposite one.
void set_force(Joints& joints, Index joint, const std::array<Point, 2>& on_first);

}  // namespace percolith::mechanics

#include "percolith/mechanics/build_initial_stress.hpp"
