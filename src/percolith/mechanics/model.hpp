// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/compensated.hpp"
#include "percolith/material/elasticity.hpp"
#include "percolith/material/joint_strength.hpp"
#include "percolith/mesh/mesh.hpp"
#include "percolith/mesh/node_map.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

// Everything the motion of the rock works on. Arrays "per corner" have one entry a corner slot,
// "per triangle" and "per joint" one an element, all padded to whole blocks; padding moves nothing.
namespace percolith::mechanics {

using mesh::Index;

/// What acts between the two triangles of a joint.
enum class JointState : std::uint8_t {
  tied,    ///< they share nodes
  rigid,   ///< both sides belong to one rigid body
  bonded,  ///< the joint law
  closed,  ///< friction between faces that have not parted since they broke
  broken   ///< contact, if they meet
};

/// Rock as the triangles see it.
struct SolidMaterial {
  material::ElasticRock rock;
  material::PlaneStiffness<double> stiffness;
  double viscosity = 0.0;        ///< of 2 mu D in (8), Pa s
  double viscosity_ratio = 0.0;  ///< the same over 2 h sqrt(E rho)
};

/// Triangles: what never changes but for excavation.
struct Triangles {
  std::vector<double> ax, ay;        ///< undeformed edge from corner 0 to 1, m
  std::vector<double> bx, by;        ///< undeformed edge from corner 0 to 2, m
  std::vector<double> inverse_mass;  ///< of each corner, m/kg; 0: removed, or padding
  std::vector<double> weight;        ///< gravity on each corner, N/m; empty without gravity
  std::vector<double> viscosity;     ///< mu, Pa s; empty where nothing is viscous
  std::vector<double> initial_xx, initial_yy, initial_xy;  ///< in-situ stress, Pa; or empty
  std::vector<Index> material;                             ///< index of `Model::material`
  std::vector<std::uint8_t> uniform;  ///< per block: 1 where all have one material
  std::vector<Index> edge_joint;      ///< per corner: code of the joint of the edge k to k + 1
};

/// What the bonds of joints past their peak have spent, and what it takes to go on with it.
struct JointPast {
  std::array<std::vector<double>, 2> opening, slip;  ///< in the last step, m, [point]
  std::array<std::vector<double>, 2> normal, shear;  ///< traction in the last step, Pa, [point]
  std::array<std::vector<double>, 2> slope;          ///< of cohesion over slip, Pa/m, [point]
  std::array<std::vector<double>, 2> friction;       ///< part of the shear traction, Pa, [point]
  std::vector<double> spent;                         ///< by the bond, friction not included, J/m
  std::vector<double> rubbed;                        ///< by friction while the bond softened, J/m
};

/// Joints, bonded or not: a joint that is not bonded has stiffness 0 and so carries nothing.
struct Joints {
  std::vector<Index> slot;        ///< 32 a block: corners side 0 end 0, 0 1, 1 0, 1 1, eight each
  std::vector<double> ex, ey;     ///< undeformed edge from end 0 to end 1, m
  std::vector<double> length;     ///< of that edge, m
  std::vector<double> stiffness;  ///< k = p_f/h, Pa/m
  std::vector<double> full_stiffness;  ///< the same were it bonded, Pa/m
  std::vector<double> size;            ///< h, m: mean `element_size` of both triangles
  std::vector<Index> strength;         ///< index of `Model::kind`
  std::vector<std::uint8_t> uniform;   ///< per block: 1 where all have one strength
  std::vector<double> factor;          ///< on strengths, from heterogeneity; or empty
  std::array<std::vector<double>, 2> opening_start, slip_start;  ///< in-situ: traction/k; or empty
  std::array<std::vector<double>, 2> opening_peak, slip_peak, damage;  ///< [point]
  JointPast past;
  std::vector<std::uint8_t> condition;  ///< per block, `BlockCondition`
  std::vector<JointState> state;
  std::vector<double> force;  ///< 32 a block: x and y on side 0 at end 0, at end 1, N/m
};

/// What has happened to the joints of a block: none was ever past its peak; some were; some have
/// failed in the last step; none is bonded, so that none carries anything.
enum class BlockCondition : std::uint8_t { whole = 0, damaged = 1, failed = 2, gone = 3 };

/// Strength and what follows from it, per kind of joint.
struct JointKind {
  material::JointStrength strength;
  double friction = 0.0;           ///< tan of the friction angle
  double residual_friction = 0.0;  ///< of closed faces
  Index owner = 0;                 ///< number of the material or fracture table it comes from
};

/// A joint of which only friction is left, kept as long as its faces stay together.
struct ClosedJoint {
  Index joint = 0;
  double stiffness = 0.0;         ///< k, Pa/m
  double friction = 0.0;          ///< tan of the residual friction angle
  std::array<double, 2> shear{};  ///< traction along the joint in the last step, Pa, [point]
  std::array<double, 2> slip{};   ///< in the last step, m, [point]
  std::array<double, 2> slip_at_start{};  ///< m, [point]
  Point turn{};                           ///< N/m: keeps moments balanced, see `add_turns`
  double loss = 0.0;                      ///< spent by friction in the last step, J/m
  bool ended = false;                     ///< its faces have parted or slid too far
};

/// Fluid in the pores as the motion of the rock sees it; all empty where the rock is dry.
struct PoreFluid {
  std::span<const double> pressure;  ///< per corner, Pa: kept by whoever computes the flow
  std::vector<double> biot;          ///< per triangle: Biot coefficient alpha, 1
  std::vector<double> stiffness;     ///< per triangle: alpha^2 M of undrained rock, Pa
  std::vector<double> growth;        ///< per triangle: alpha (A - A_0) at the present places, m2
  /// Per joint: alpha where its bond carries the effective stress, so that the pressure of the
  /// pores on both sides acts besides; else 0.
  std::vector<double> joint_share;
  std::array<std::vector<double>, 2> push;     ///< per joint [point]: that pressure, last step, Pa
  std::array<std::vector<double>, 2> opening;  ///< per joint [point]: in the last step, m
};

/// Fluid between the faces of one joint that belongs to the crack network: half of the force of
/// its pressure goes to each end, that of the crack node there (37).
struct PressedFaces {
  Index joint = 0;
  std::array<double, 2> pressure{};       ///< Pa, at the ends
  std::array<double, 2> opening{};        ///< m, at the ends, now
  double compression = 0.0;               ///< Pa: of the faces on each other, now
  Point across{};                         ///< from side 0 to side 1, now
  std::array<double, 2> last_pressure{};  ///< Pa, when the faces were last pressed
  std::array<double, 2> last_opening{};   ///< m, then
};

/// Displacement and velocity.
struct Motion {
  double time = 0.0;           ///< s
  double last_step = 0.0;      ///< s; 0 before the first
  std::vector<double> ux, uy;  ///< per corner, m
  std::vector<double> vx, vy;  ///< per corner, m/s, in the middle of the last step
};

/// Corners that do not move as forces say: v = P v_free + w.
struct Constraints {
  std::vector<Index> record;  ///< per block of triangles: number of its record, or `none`
  // 24 entries a record, in the order of the corner slots of the block.
  std::vector<double> pxx, pxy, pyy;  ///< P
  std::vector<double> wx, wy;         ///< w, m/s
  std::vector<double> rx, ry;         ///< force of the support on the rock, N/m
};

/// Forces from outside, per corner, and the blocks where there are any.
struct Loads {
  std::vector<double> fx, fy;      ///< N/m
  std::vector<std::uint8_t> acts;  ///< per block of triangles
  /// Per triangle: resistance of the dashpots at its worst corner, kg/(m s); empty without.
  std::vector<double> resistance{};
};

/// Works and energies since time zero, J/m.
struct Energies {
  double kinetic = 0.0;
  CompensatedSum load_work;  ///< of tractions, pressures and point forces
  CompensatedSum gravity_work;
  CompensatedSum support_work;      ///< of the supports
  CompensatedSum fluid_work;        ///< of fluid in pores and cracks on the rock
  CompensatedSum damping;           ///< spent by nodal viscosity and local damping, positive
  CompensatedSum viscous;           ///< spent by element viscosity, positive
  CompensatedSum absorbed;          ///< let out through absorbing boundaries, positive
  CompensatedSum closed_friction;   ///< spent by slip of closed joints, positive
  CompensatedSum taken_out;         ///< held by triangles that were taken out
  CompensatedSum joints_taken_out;  ///< held by their joints
  double unbalanced = 0.0;          ///< sum of |F| over the corners, last step, N/m
  double internal = 0.0;            ///< sum of |internal force|, last step, N/m
};

struct Damping {
  double nodal_viscosity = 0.0;  ///< mu of (2), kg/(m s)
  double local = 0.0;            ///< share of the unbalanced force
};

/// The rock in motion.
struct Model {
  mesh::Mesh mesh;
  material::Plane plane = material::Plane::strain;
  std::vector<SolidMaterial> material;
  std::vector<JointKind> kind;
  Damping damping;
  Triangles triangles;
  Joints joints;
  std::vector<ClosedJoint> closed;   ///< ascending in joints
  std::vector<std::uint8_t> tied;    ///< per joint: shares nodes
  std::vector<std::uint8_t> bonded;  ///< per joint: tied, rigid or bonded
  mesh::NodeMap nodes;               ///< corners that move together
  mesh::NodeMap fans;                ///< corners connected through tied or bonded joints
  bool any_tied = false;
  Constraints constraints;
  Loads loads;
  PoreFluid pores{};
  std::vector<PressedFaces> pressed{};  ///< ascending in joints
  Motion motion;
  Energies energy;
};

/// `JointKind::owner` of a joint.
inline Index owner_of(const Model& model, Index joint) {
  return model.kind[at(model.joints.strength[at(joint)])].owner;
}

/// Where the force of a joint starts in `Joints::force`: x at end 0, y eight further, end 1 sixteen
/// further.
PERCOLITH_DEVICE Index force_slot(Index joint) {
  return joint / block_width * (4 * block_width) + joint % block_width;
}

/// `Triangles::edge_joint`: the slot of the force at the corner where the edge starts; that where
/// it ends is the slot with `other_end` flipped. The triangle of side 1 walks the edge from end 1
/// to end 0 and gets the opposite force, so the same bit tells its sign.
inline constexpr Index other_end = 2 * block_width;
PERCOLITH_DEVICE Index edge_code(Index joint, Index side) {
  return force_slot(joint) + side * other_end;
}

}  // namespace percolith::mechanics
