// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/option.hpp"
#include "percolith/simulation/setup.hpp"

// The options of mechanics: elasticity and strength, and the tables that only mechanics has.
namespace percolith::case_file {

template <class V>
void list_elasticity(V& option, material::ElasticRock& m) {
  constexpr std::string_view needed = "required in mechanics";
  option(m.density, Quantity{"density", "kg/m3", positive, Need::optional,
                             "Mass per volume of the rock with its pores.", needed});
  option(m.young_modulus,
         Quantity{"young_modulus", "Pa", positive, Need::optional,
                  "Young's modulus; of layered rock that along the layers.", needed});
  option(m.poisson_ratio,
         Quantity{"poisson_ratio", "1", Bounds{-1.0, 1.0, false, false}, Need::optional,
                  "Poisson's ratio, below 0.5; of layered rock that within the "
                  "layers, below 1.",
                  needed});
  option(m.normal_young_modulus,
         Quantity{"normal_young_modulus", "Pa", positive, Need::optional,
                  "Young's modulus across the layers of a layered rock.", "not layered"});
  option(
      m.normal_poisson_ratio,
      Quantity{"normal_poisson_ratio", "1", finite, Need::optional,
               "Poisson's ratio of stress across the layers: contraction along them over extension "
               "across them. Needs normal_young_modulus.",
               "poisson_ratio normal_young_modulus/young_modulus"});
  option(m.normal_shear_modulus,
         Quantity{"normal_shear_modulus", "Pa", positive, Need::optional,
                  "Shear modulus G between the layers. Needs normal_young_modulus.",
                  "1/G = (1 + 2 normal_poisson_ratio)/normal_young_modulus + 1/young_modulus"});
  option(m.bedding_angle,
         Quantity{"bedding_angle", "rad", finite, Need::optional,
                  "Angle of the layers from the x axis, counter-clockwise, such as \"30 deg\". "
                  "Needs normal_young_modulus."});
}

/// What the strengths of a rock and of a fracture are called and mean.
struct StrengthHelp {
  std::string_view needed;    ///< when the strengths must be given
  std::string_view friction;  ///< when friction_angle must be given
  std::string_view residual;  ///< what holds without residual_friction_angle
};

template <class V>
void list_strength(V& option, material::JointStrength& m, const StrengthHelp& help) {
  option(m.tensile_strength, Quantity{"tensile_strength", "Pa", not_negative, Need::optional,
                                      "Tensile strength of the joints.", help.needed});
  option(m.cohesion, Quantity{"cohesion", "Pa", not_negative, Need::optional,
                              "Shear strength of the joints without normal stress.", help.needed});
  option(m.friction_angle,
         Quantity{"friction_angle", "rad", slope_angle, Need::optional,
                  "Friction angle of the joints, such as \"30 deg\".", help.friction});
  option(m.residual_friction_angle,
         Quantity{"residual_friction_angle", "rad", slope_angle, Need::optional,
                  "Friction angle of broken joints and of contact.", help.residual});
  option(m.mode_1_energy,
         Quantity{"mode_1_energy", "J/m2", not_negative, Need::optional,
                  "Energy that a joint spends to open, after its peak; zero just where "
                  "tensile_strength is.",
                  help.needed});
  option(m.mode_2_energy, Quantity{"mode_2_energy", "J/m2", not_negative, Need::optional,
                                   "Energy that a joint spends to slip, after its peak and above "
                                   "residual friction; zero just where cohesion is.",
                                   help.needed});
  option(m.joint_penalty, Quantity{"joint_penalty", "Pa", positive, Need::optional,
                                   "Stiffness of a joint times the size of its elements.",
                                   "20 times Young's modulus of the softer side"});
}

template <class V>
void describe(V& option, simulation::Body& m) {
  option(m.regions,
         Text{"regions", Need::required, "Physical surfaces of the mesh that are this body."});
  option(m.rigid, Flag{"rigid", "Whether the body keeps its shape and moves as its velocities say, "
                                "like a platen of a press."});
  option(m.velocity_x,
         Quantity{"velocity_x", "m/s", finite, Need::optional,
                  "Velocity along x, over time. Needs rigid = true.", "0", "velocity"});
  option(m.velocity_y,
         Quantity{"velocity_y", "m/s", finite, Need::optional,
                  "Velocity along y, over time. Needs rigid = true.", "0", "velocity"});
  option(m.initial_velocity_x,
         Quantity{"initial_velocity_x", "m/s", finite, Need::optional,
                  "Velocity along x at time zero. Needs rigid = false.", "0", "velocity"});
  option(m.initial_velocity_y,
         Quantity{"initial_velocity_y", "m/s", finite, Need::optional,
                  "Velocity along y at time zero. Needs rigid = false.", "0", "velocity"});
}

template <class V>
void describe(V& option, simulation::PointForce& m) {
  option(m.point, Quantity{"point", "m", finite, Need::required,
                           "Place [x, y]; the vertex nearest to it takes the force."});
  option(m.force_x, Quantity{"force_x", "N/m", finite, Need::optional,
                             "Force along x per metre of thickness, over time.", "0"});
  option(m.force_y, Quantity{"force_y", "N/m", finite, Need::optional,
                             "Force along y per metre of thickness, over time.", "0"});
}

template <class V>
void describe(V& option, simulation::InSitu& m) {
  option(m.stress_xx, Quantity{"stress_xx", "Pa", finite, Need::optional,
                               "Normal stress along x at the datum, tension positive."});
  option(m.stress_yy, Quantity{"stress_yy", "Pa", finite, Need::optional,
                               "Normal stress along y at the datum, tension positive."});
  option(m.stress_xy,
         Quantity{"stress_xy", "Pa", finite, Need::optional, "Shear stress at the datum."});
  option(m.stress_zz, Quantity{"stress_zz", "Pa", finite, Need::optional,
                               "Normal stress across the plane at the datum, tension positive: a "
                               "part of the field stress_zz. Needs plane = \"strain\"."});
  option(m.gradient_xx, Quantity{"gradient_xx", "Pa/m", finite, Need::optional,
                                 "Growth of the normal stress along x per metre of elevation."});
  option(m.gradient_yy, Quantity{"gradient_yy", "Pa/m", finite, Need::optional,
                                 "Growth of the normal stress along y per metre of elevation."});
  option(m.gradient_xy, Quantity{"gradient_xy", "Pa/m", finite, Need::optional,
                                 "Growth of the shear stress per metre of elevation."});
  option(m.gradient_zz,
         Quantity{"gradient_zz", "Pa/m", finite, Need::optional,
                  "Growth of the normal stress across the plane per metre of elevation. Needs "
                  "plane = \"strain\"."});
  option(m.datum, Quantity{"datum", "m", finite, Need::optional,
                           "Elevation y at which the stresses hold. Needs a gradient."});
}

template <class V>
void describe(V& option, simulation::Excavation& m) {
  option(m.regions,
         Text{"regions", Need::required, "Physical surfaces of the mesh that are taken out."});
  option(m.start,
         Quantity{"start", "s", not_negative, Need::optional, "Time at which they are taken out."});
  option(m.duration, Quantity{"duration", "s", not_negative, Need::optional,
                              "Time in which the forces they gave to the rest fade to nothing."});
  option(m.pressure, Quantity{"pressure", "Pa", finite, Need::optional,
                              "Pressure of the fluid in the opening, and so in the pores and "
                              "cracks at its walls, from the start of the excavation on."});
  option(m.pressurised,
         Flag{"pressurised", "Whether this fluid presses on the rock of the walls as well, as much "
                             "as what was there before has faded; false where a lining bears it. "
                             "Needs a pressure other than 0."});
}

template <class V>
void describe(V& option, simulation::Damping& m) {
  option(m.nodal_viscosity, Quantity{"nodal_viscosity", "kg/(m s)", not_negative, Need::optional,
                                     "Force against the motion of a node over its velocity."});
  option(m.element_viscosity, Quantity{"element_viscosity", "Pa s", not_negative, Need::optional,
                                       "Viscosity mu of the stress 2 mu D in the triangles, D the "
                                       "rate of deformation."});
  option(m.viscosity_ratio,
         Quantity{"viscosity_ratio", "1", not_negative, Need::optional,
                  "The same over 2 h sqrt(E rho), h the size of the triangle. Only one of both."});
  option(m.local, Quantity{"local", "1", Bounds{0.0, 1.0, true, false}, Need::optional,
                           "Share of the unbalanced force that acts against the motion; for runs "
                           "that seek rest."});
}

template <class V>
void describe(V& option, simulation::ContactOptions& m) {
  option(m.penalty, Quantity{"penalty", "Pa", positive, Need::optional,
                             "Stiffness of contact times the size of the elements.",
                             "as stiff as the joints"});
  option(m.tangential_penalty, Quantity{"tangential_penalty", "Pa/m", positive, Need::optional,
                                        "Stress of friction per slip before the faces slide.",
                                        "as stiff along the faces as across"});
}

}  // namespace percolith::case_file
