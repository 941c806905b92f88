// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/describe_mechanics.hpp"
#include "percolith/case/option.hpp"
#include "percolith/simulation/setup.hpp"

#include <limits>

// The options of the model itself: mesh, laws, fluid, rocks and fractures.
namespace percolith::case_file {

template <class V>
void describe(V& option, simulation::MeshOptions& m) {
  option(m.file, Text{"file", Need::required,
                      "Gmsh mesh (.msh, version 2.2 or 4.1, ASCII or binary) or geometry (.geo, "
                      "meshed by the gmsh program); relative to the case file."});
  option(m.element_size, Quantity{"element_size", "m", not_negative, Need::optional,
                                  "Upper bound of the element size when a .geo is meshed; 0 keeps "
                                  "the sizes of the geometry."});
}

/// The part of the model that only coupled physics has.
template <class V>
void list_coupling(V& option, simulation::Model& m) {
  using simulation::CrackStorage;
  using simulation::FluidEnters;
  using simulation::JointStress;
  option(m.joint_stress,
         Choice<JointStress>{
             "joint_stress",
             {{JointStress::effective, "effective"}, {JointStress::total, "total"}},
             "Stress that the strength of a joint is compared with: effective, to which the pore "
             "pressure adds nothing, or total, as in the paper, which makes wet rock stronger."});
  option(m.fluid_enters,
         Choice<FluidEnters>{
             "fluid_enters",
             {{FluidEnters::broken, "broken"}, {FluidEnters::softening, "softening"}},
             "When the fluid of cracks gets into a joint: once it has broken, or already when it "
             "is past its peak, for cracks whose dry tip would falsify their pressure."});
  option(m.crack_storage,
         Choice<CrackStorage>{
             "crack_storage",
             {{CrackStorage::unclamped, "unclamped"}, {CrackStorage::clamped, "clamped"}},
             "Whether maximum_aperture limits only what cracks conduct, or also, as in the paper, "
             "what they hold; the latter does not conserve energy."});
}

template <class V>
void describe(V& option, simulation::Model& m) {
  using simulation::Physics;
  using simulation::Plane;
  option(m.physics,
         Choice<Physics>{"physics",
                         {{Physics::seepage, "seepage"},
                          {Physics::mechanics, "mechanics"},
                          {Physics::coupled, "coupled"}},
                         "What is computed: seepage through a rock at rest, the mechanics of a dry "
                         "rock that deforms, breaks and moves, or both coupled."});
  option(m.plane, Choice<Plane>{"plane",
                                {{Plane::strain, "strain"}, {Plane::stress, "stress"}},
                                "Whether strain or stress across the plane of the model is "
                                "zero."});
  option(m.gravity, Quantity{"gravity", "m/s2", not_negative, Need::required,
                             "Acceleration of gravity along -y: 9.81 for a vertical section, 0 for "
                             "a horizontal plan."});
  option(m.head_datum, Quantity{"head_datum", "m", finite, Need::optional,
                                "Elevation y from which hydraulic head is measured, so that head = "
                                "y - head_datum + pressure/(density gravity). Needs gravity."});
  option(m.pore_joints,
         Choice<simulation::PoreJoints>{
             "pore_joints",
             {{simulation::PoreJoints::tied, "tied"}, {simulation::PoreJoints::finite, "finite"}},
             "How pore pressure crosses an unbroken joint: tied shares it, finite lets the fluid "
             "pass a large conductance."});
  option(m.joint_factor, Quantity{"joint_factor", "1", positive, Need::optional,
                                  "Factor n of the conductance n k/(mu L) of finite joints. Needs "
                                  "pore_joints = \"finite\"."});
  option(m.saturation_weight, Choice<simulation::SaturationWeight>{
                                  "saturation_weight",
                                  {{simulation::SaturationWeight::upstream, "upstream"},
                                   {simulation::SaturationWeight::mean, "mean"}},
                                  "Saturation that weights the flow in partly saturated rock: that "
                                  "of the upstream corner, or the mean of the triangle."});
  list_coupling(option, m);
}

template <class V>
void describe(V& option, material::Fluid& m) {
  option(m.density, Quantity{"density", "kg/m3", positive, Need::optional, "Density."});
  option(m.viscosity,
         Quantity{"viscosity", "Pa s", positive, Need::optional, "Dynamic viscosity."});
  option(m.bulk_modulus, Quantity{"bulk_modulus", "Pa", positive, Need::optional,
                                  "Bulk modulus (the inverse of the compressibility)."});
  option(m.cavitation_pressure,
         Quantity{"cavitation_pressure", "Pa", finite_or_minus_infinite, Need::optional,
                  "Pressure at which voids begin to empty; \"-inf\" keeps them always full."});
}

template <class V>
void describe(V& option, simulation::Material& m) {
  option(m.regions, Text{"regions", Need::required,
                         "Physical surfaces of the mesh that are made of this rock."});
  option(m.rock.permeability,
         Quantity{"permeability", "m2", finite, Need::optional,
                  "Intrinsic permeability: one value, or the tensor as [kxx, kyy, kxy] or "
                  "[[kxx, kxy], [kxy, kyy]]; positive definite.",
                  "required with flow"});
  option(m.rock.porosity,
         Quantity{"porosity", "1", positive_fraction, Need::optional,
                  "Volume of pores over volume of rock; 1 is a region of fluid that "
                  "flows as in a porous rock.",
                  "required with flow"});
  option(m.rock.biot_modulus,
         Quantity{"biot_modulus", "Pa", positive, Need::optional,
                  "Biot modulus: pressure per fluid content at constant volume.",
                  "bulk modulus of the fluid over porosity"});
  option(m.biot_coefficient,
         Quantity{"biot_coefficient", "1", not_negative, Need::optional,
                  "Biot coefficient alpha: share of the pore pressure that the rock bears."});
  list_elasticity(option, m.solid);
  using simulation::RockJoints;
  option(m.joints, Choice<RockJoints>{
                       "joints",
                       {{RockJoints::breakable, "breakable"}, {RockJoints::elastic, "elastic"}},
                       "Whether the joints between triangles may break, or the rock stays "
                       "whole and elastic."});
  list_strength(option, m.strength,
                {"required where joints are breakable",
                 "required where joints are breakable or in a body; else 0", "friction_angle"});
  option(m.weibull_modulus,
         Quantity{"weibull_modulus", "1", positive, Need::optional,
                  "Weibull modulus of the strengths, which then differ from joint to joint.",
                  "all joints alike"});
  option(m.weibull_seed, Count{"weibull_seed", 0, std::numeric_limits<int>::max(), Need::optional,
                               "Number that chooses the strengths. Needs weibull_modulus."});
}

/// The flow in a fracture; `needed` says when aperture and exchange must be given.
template <class V>
void list_hydraulics(V& option, material::Fracture& m, std::string_view needed) {
  option(m.initial_aperture, Quantity{"initial_aperture", "m", positive, Need::optional,
                                      "Hydraulic aperture at zero opening.", needed});
  option(m.minimum_aperture,
         Quantity{"minimum_aperture", "m", not_negative, Need::optional,
                  "Lower bound of the aperture, of what conducts and of what holds fluid; above 0 "
                  "where rock moves, since fluid without room would be infinitely stiff.",
                  "0; in coupled physics initial_aperture/10, or /100 with closure_stress, and at "
                  "most maximum_aperture"});
  option(m.maximum_aperture,
         Quantity{"maximum_aperture", "m", positive_or_infinite, Need::optional,
                  "Upper bound of the aperture that conducts. Needs the cubic law, or "
                  "crack_storage = \"clamped\"."});
  option(m.closure_stress,
         Quantity{"closure_stress", "Pa", positive, Need::optional,
                  "Effective normal stress s_ref that closes the fracture to a tenth: the aperture "
                  "at zero opening is initial_aperture/(1 + 9 s/s_ref) under the stress s.",
                  "initial_aperture whatever the stress"});
  option(m.transmissivity,
         Quantity{"transmissivity", "m3", positive, Need::optional,
                  "Intrinsic transmissivity: permeability along the fracture times aperture.",
                  "cubic law, aperture^3/12"});
  option(m.exchange,
         Quantity{"exchange", "m/(Pa s)", not_negative_or_infinite, Need::optional,
                  "Flux between the fracture and one of its faces per pressure difference; \"inf\" "
                  "gives fracture and faces one pressure, 0 seals the faces.",
                  needed});
}

template <class V>
void describe(V& option, simulation::NewCracks& m) {
  list_hydraulics(option, m.fracture, "required");
}

template <class V>
void describe(V& option, simulation::FractureGroup& m) {
  option(m.groups, Text{"groups", Need::required,
                        "Physical curves of the mesh that are fractures of this kind."});
  list_hydraulics(option, m.fracture, "required with flow");
  using simulation::Bond;
  option(m.bond, Choice<Bond>{"bond",
                              {{Bond::broken, "broken"}, {Bond::cohesive, "cohesive"}},
                              "Whether the fracture is broken from the start, or bonded with "
                              "strengths of its own."});
  list_strength(option, m.strength,
                {"required with bond = \"cohesive\"",
                 "required with bond = \"cohesive\"; else that of the material",
                 "friction_angle; where none is given that of the material"});
}

}  // namespace percolith::case_file
