// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/vec2.hpp"
#include "percolith/coupling/options.hpp"
#include "percolith/material/elastic_rock.hpp"
#include "percolith/material/fluid.hpp"
#include "percolith/material/fracture.hpp"
#include "percolith/material/joint_strength.hpp"
#include "percolith/material/pore_rock.hpp"
#include "percolith/seepage/options.hpp"
#include "percolith/time/schedule.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

// What a simulation is told, as plain values in SI units. The case room fills it from a file; the
// dotted path of an option there is the path of the member here (`time.end`,
// `boundary.left.pressure`), so that an error raised anywhere can name its option.
namespace percolith::simulation {

using coupling::FluidEnters;
using coupling::JointStress;
using coupling::PoreFlow;
using material::Plane;
using seepage::PoreJoints;
using seepage::SaturationWeight;
/// What is computed: flow through a rock at rest, the motion of a dry rock, or both together.
enum class Physics { seepage, mechanics, coupled };
[[nodiscard]] constexpr bool has_flow(Physics physics) {
  return physics != Physics::mechanics;
}
[[nodiscard]] constexpr bool has_motion(Physics physics) {
  return physics != Physics::seepage;
}
/// Whether the maximum aperture limits only what a crack conducts, or also what it holds.
enum class CrackStorage { unclamped, clamped };
/// Whether the joints of a region may break, or its triangles share nodes and stay bonded.
enum class RockJoints { breakable, elastic };
/// Whether a fracture is broken from the start, or bonded with strengths of its own.
enum class Bond { broken, cohesive };
/// How the flow is advanced in time (theory.md section 6).
enum class Scheme { implicit, explicit_, steady, quasi_static };
/// Which pressures a boundary condition or a point source acts on.
enum class Domain { both, matrix, crack };

struct MeshOptions {
  std::string file;           ///< `.msh` or `.geo`, relative to the case file
  double element_size = 0.0;  ///< m; > 0: upper bound of the size when a `.geo` is meshed
  friend bool operator==(const MeshOptions&, const MeshOptions&) = default;
};

struct Model {
  Physics physics = Physics::seepage;
  Plane plane = Plane::strain;
  double gravity = 9.81;    ///< m/s2, along -y
  double head_datum = 0.0;  ///< m: elevation from which head is measured
  PoreJoints pore_joints = PoreJoints::tied;
  double joint_factor = 100.0;  ///< n of h_j = n k/(mu L_e), for finite joints
  SaturationWeight saturation_weight = SaturationWeight::upstream;
  JointStress joint_stress = JointStress::effective;
  FluidEnters fluid_enters = FluidEnters::broken;
  CrackStorage crack_storage = CrackStorage::unclamped;
  friend bool operator==(const Model&, const Model&) = default;
};

struct Material {
  std::vector<std::string> regions;  ///< physical surfaces
  material::PoreRock rock;
  double biot_coefficient = 1.0;  ///< alpha, 1
  material::ElasticRock solid{};
  material::JointStrength strength{};
  RockJoints joints = RockJoints::breakable;
  /// Weibull modulus m of the strengths from joint to joint; absent: all alike.
  std::optional<double> weibull_modulus{};
  int weibull_seed = 1;
  friend bool operator==(const Material&, const Material&) = default;
};

struct FractureGroup {
  std::vector<std::string> groups;  ///< physical curves
  material::Fracture fracture;
  Bond bond = Bond::broken;
  material::JointStrength strength{};  ///< mechanics
  friend bool operator==(const FractureGroup&, const FractureGroup&) = default;
};

/// What the flow needs to know of cracks that open during the run.
struct NewCracks {
  material::Fracture fracture;
  friend bool operator==(const NewCracks&, const NewCracks&) = default;
};

/// A condition on boundary edges. Of seepage exactly one of pressure, head, flux, seepage_face is
/// given; of mechanics one or more of the others that do not contradict each other.
struct BoundaryCondition {
  std::vector<std::string> groups;                         ///< physical curves
  std::optional<Schedule> pressure;                        ///< Pa
  std::optional<Schedule> head;                            ///< m above head_datum
  std::optional<Schedule> flux;                            ///< m/s, positive into the rock
  std::optional<Schedule> seepage_face;                    ///< Pa: outside pressure; outflow only
  Domain on = Domain::both;                                ///< for pressure, head and seepage face
  bool fixed = false;                                      ///< no displacement
  bool roller = false;                                     ///< no displacement normal to the edges
  std::optional<Schedule> displacement_x, displacement_y;  ///< m
  std::optional<Schedule> velocity_x, velocity_y;          ///< m/s
  std::optional<Schedule> traction_x, traction_y;          ///< Pa, on the undeformed edges
  std::optional<Schedule> normal_pressure;                 ///< Pa, follows the deformed edges
  bool pressurised = false;  ///< the pressure of the flow presses the rock too
  bool in_situ = false;      ///< carries the traction of the in-situ stress
  bool absorbing = false;    ///< lets waves leave (Lysmer)
  friend bool operator==(const BoundaryCondition&, const BoundaryCondition&) = default;
};

/// Fluid brought in at a point or along fractures. Exactly one of point and fractures, and exactly
/// one of rate and pressure, is given.
struct Source {
  std::optional<std::array<double, 2>> point;  ///< m
  std::vector<std::string> fractures;          ///< names of fracture tables
  Domain into = Domain::matrix;                ///< for a point: matrix or crack
  std::optional<Schedule> rate;                ///< m2/s (per metre of thickness), positive inwards
  std::optional<Schedule> pressure;            ///< Pa; fractures, or a point in a crack
  friend bool operator==(const Source&, const Source&) = default;
};

/// A part of the model that moves in its own way: a rigid platen, or a body that is thrown.
struct Body {
  std::vector<std::string> regions;  ///< physical surfaces
  bool rigid = false;                ///< does not deform and moves as the velocities say
  std::optional<Schedule> velocity_x, velocity_y;                ///< m/s, rigid; absent: 0
  std::optional<double> initial_velocity_x, initial_velocity_y;  ///< m/s, not rigid
  friend bool operator==(const Body&, const Body&) = default;
};

/// A force on the vertex nearest to a point.
struct PointForce {
  std::array<double, 2> point{};             ///< m
  std::optional<Schedule> force_x, force_y;  ///< N/m
  friend bool operator==(const PointForce&, const PointForce&) = default;
};

/// Stress of the rock at time zero: stress + gradient (y - datum), tension positive.
struct InSitu {
  double stress_xx = 0.0, stress_yy = 0.0, stress_xy = 0.0;        ///< Pa
  double gradient_xx = 0.0, gradient_yy = 0.0, gradient_xy = 0.0;  ///< Pa/m
  double datum = 0.0;                                              ///< m
  /// Across the plane: a part of the stress that is written out, of no effect on the motion.
  double stress_zz = 0.0, gradient_zz = 0.0;  ///< Pa, Pa/m
  friend bool operator==(const InSitu&, const InSitu&) = default;
};

/// Regions that are taken out; the forces they gave to the rest fade over a duration.
struct Excavation {
  std::vector<std::string> regions;  ///< physical surfaces
  double start = 0.0;                ///< s
  double duration = 0.0;             ///< s
  double pressure = 0.0;             ///< Pa: of the fluid at the new walls from the start on
  bool pressurised = true;           ///< this pressure acts on the rock of the walls as well
  friend bool operator==(const Excavation&, const Excavation&) = default;
};

struct Damping {
  double nodal_viscosity = 0.0;    ///< mu of C = mu I, (2), kg/(m s)
  double element_viscosity = 0.0;  ///< mu of 2 mu D, (8), Pa s
  double viscosity_ratio = 0.0;    ///< element viscosity over 2 h sqrt(E rho)
  double local = 0.0;              ///< non-viscous: share of the unbalanced force
  friend bool operator==(const Damping&, const Damping&) = default;
};

struct ContactOptions {
  /// p_n, Pa: of the overlap potential; absent: as stiff as the joints.
  std::optional<double> penalty;
  std::optional<double> tangential_penalty;  ///< p_t, Pa/m; absent: as stiff as across
  friend bool operator==(const ContactOptions&, const ContactOptions&) = default;
};

/// State at time zero. At most one of pressure, head, water_table and steady is given; none:
/// pressure 0.
struct Initial {
  bool steady = false;                     ///< the steady state under the conditions at time zero
  std::optional<double> pressure;          ///< Pa
  std::optional<double> head;              ///< m
  std::optional<double> water_table;       ///< m: y at which the hydrostatic pressure is zero
  double saturation = 1.0;                 ///< of the pores
  std::optional<double> crack_pressure;    ///< Pa; when absent as in the pores
  std::optional<double> crack_saturation;  ///< when absent as in the pores
  friend bool operator==(const Initial&, const Initial&) = default;
};

struct Stepping {
  Scheme scheme = Scheme::implicit;
  double end = 0.0;                    ///< s; unused when steady
  std::optional<double> step;          ///< s: fixed step (implicit) or upper bound (explicit)
  std::optional<double> initial_step;  ///< s, implicit
  std::optional<double> maximum_step;  ///< s, implicit
  double tolerance = 1e-3;             ///< local error per step over the pressure range, implicit;
                                       ///< of pressures and rock agreeing, quasi-static
  /// Unbalanced force over that to be balanced, quasi-static; absent: `balance_tolerance` says.
  std::optional<double> balance_tolerance{};
  double safety = 0.9;                       ///< share of the stability limit used, explicit
  PoreFlow pore_flow = PoreFlow::explicit_;  ///< coupled, explicit
  /// A run ends early when the unbalanced force is below this share of the internal forces, or what
  /// flow alone still stores or gives up below this share of what flows through.
  std::optional<double> stop_ratio;
  std::optional<double> mass_scaling_step;  ///< s: triangles with a lower limit get more mass
  friend bool operator==(const Stepping&, const Stepping&) = default;
};

/// Values written over time at points of the plane or on a line.
struct Probe {
  std::optional<std::array<double, 2>> point;  ///< m
  std::optional<std::array<double, 2>> from;   ///< m: first point of a line
  std::optional<std::array<double, 2>> to;     ///< m: last point of a line
  int points = 101;                            ///< on the line
  Domain in = Domain::matrix;                  ///< matrix, or crack: on the nearest one
  friend bool operator==(const Probe&, const Probe&) = default;
};

struct Output {
  std::vector<double> times;                  ///< s
  std::optional<double> interval;             ///< s
  bool fields = true;                         ///< write the field series
  std::optional<double> history_interval;     ///< s between rows of history; absent: every
                                              ///< implicit step, a thousandth of the explicit run
  std::optional<double> checkpoint_interval;  ///< s, of the simulation
  double checkpoint_wall_interval = 600.0;    ///< s, on the wall; 0: none
  friend bool operator==(const Output&, const Output&) = default;
};

/// The balance of forces in a quasi-static run, over its tolerance of the pressures: by default,
/// and at most.
inline constexpr double balance_share = 0.1;
inline constexpr double largest_balance_share = 0.5;

/// Unbalanced force over that to be balanced which a quasi-static step may leave.
[[nodiscard]] inline double balance_tolerance(const Stepping& time) {
  return time.balance_tolerance.value_or(balance_share * time.tolerance);
}

struct Setup {
  int format = 1;
  std::string title;
  MeshOptions mesh;
  Model model;
  material::Fluid fluid;
  std::map<std::string, Material> material;
  std::map<std::string, FractureGroup> fracture;
  std::optional<NewCracks> new_cracks{};
  std::map<std::string, BoundaryCondition> boundary;
  std::map<std::string, Source> source;
  std::map<std::string, Body> body;
  std::map<std::string, PointForce> point_force;
  std::optional<InSitu> in_situ;
  std::map<std::string, Excavation> excavation;
  Damping damping;
  ContactOptions contact;
  Initial initial;
  Stepping time;
  Output output;
  std::map<std::string, Probe> probe;
  friend bool operator==(const Setup&, const Setup&) = default;
};

}  // namespace percolith::simulation
