// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/option.hpp"
#include "percolith/simulation/setup.hpp"

// The options of boundary, source and initial conditions.
namespace percolith::case_file {

/// The part of a boundary condition that mechanics has.
template <class V>
void list_mechanical(V& option, simulation::BoundaryCondition& m) {
  option(m.fixed, Flag{"fixed", "Whether the boundary stays where it is."});
  option(m.roller, Flag{"roller", "Whether the boundary stays in its place across its edges, and "
                                  "slides freely along them."});
  option(m.displacement_x, Quantity{"displacement_x", "m", finite, Need::optional,
                                    "Displacement along x, over time.", "free"});
  option(m.displacement_y, Quantity{"displacement_y", "m", finite, Need::optional,
                                    "Displacement along y, over time.", "free"});
  option(m.velocity_x, Quantity{"velocity_x", "m/s", finite, Need::optional,
                                "Velocity along x, over time.", "free", "velocity"});
  option(m.velocity_y, Quantity{"velocity_y", "m/s", finite, Need::optional,
                                "Velocity along y, over time.", "free", "velocity"});
  option(m.traction_x,
         Quantity{"traction_x", "Pa", finite, Need::optional,
                  "Force along x per area of the undeformed boundary, over time.", "0"});
  option(m.traction_y,
         Quantity{"traction_y", "Pa", finite, Need::optional,
                  "Force along y per area of the undeformed boundary, over time.", "0"});
  option(m.normal_pressure,
         Quantity{"normal_pressure", "Pa", finite, Need::optional,
                  "Pressure on the boundary as it moves and deforms, over time.", "0"});
  option(m.pressurised, Flag{"pressurised", "Whether the fluid presses on the boundary with the "
                                            "pressure of the flow there, as on the wall of a well. "
                                            "Needs pressure."});
  option(m.in_situ, Flag{"in_situ", "Whether the boundary carries the traction of the in-situ "
                                    "stress. Needs the table [in_situ]."});
  option(m.absorbing, Flag{"absorbing", "Whether waves leave through the boundary."});
}

template <class V>
void describe(V& option, simulation::BoundaryCondition& m) {
  using simulation::Domain;
  option(m.groups, Text{"groups", Need::required,
                        "Physical curves of the mesh this condition holds on; a boundary without a "
                        "condition is impervious, and free to move."});
  option(m.pressure, Quantity{"pressure", "Pa", finite, Need::optional, "Pressure, over time.",
                              "no fixed pressure"});
  option(m.head,
         Quantity{"head", "m", finite, Need::optional,
                  "Hydraulic head above head_datum, over time. Needs gravity.", "no fixed head"});
  option(m.flux, Quantity{"flux", "m/s", finite, Need::optional,
                          "Flux normal to the boundary, positive into the rock, over time.",
                          "no given flux"});
  option(m.seepage_face,
         Quantity{"seepage_face", "Pa", finite, Need::optional,
                  "Outside pressure of a face that lets fluid out but not in, over time.",
                  "no seepage face"});
  option(m.on, Choice<Domain>{
                   "on",
                   {{Domain::both, "both"}, {Domain::matrix, "matrix"}, {Domain::crack, "crack"}},
                   "Whether pressure, head or seepage face holds for the matrix, for "
                   "the fractures that end there, or for both."});
  list_mechanical(option, m);
}

template <class V>
void describe(V& option, simulation::Source& m) {
  using simulation::Domain;
  option(m.point, Quantity{"point", "m", finite, Need::optional, "Place [x, y].", "no point"});
  option(m.fractures, Text{"fractures", Need::optional,
                           "Names of the fracture tables the fluid is brought into."});
  option(m.into, Choice<Domain>{"into",
                                {{Domain::matrix, "matrix"}, {Domain::crack, "crack"}},
                                "What the fluid enters at a point."});
  option(m.rate, Quantity{"rate", "m2/s", finite, Need::optional,
                          "Volume per time and metre of thickness, positive into the rock, over "
                          "time.",
                          "no given rate"});
  option(m.pressure, Quantity{"pressure", "Pa", finite, Need::optional,
                              "Pressure in the fractures, or at a point in a crack, over time.",
                              "no fixed pressure"});
}

template <class V>
void describe(V& option, simulation::Initial& m) {
  option(m.steady, Flag{"steady", "Whether the run starts from the steady state under the "
                                  "conditions at time 0."});
  option(m.pressure, Quantity{"pressure", "Pa", finite, Need::optional, "One pressure everywhere.",
                              "0 where no head or water table is given"});
  option(m.head, Quantity{"head", "m", finite, Need::optional,
                          "One hydraulic head everywhere, above head_datum. Needs gravity.",
                          "no initial head"});
  option(m.water_table, Quantity{"water_table", "m", finite, Need::optional,
                                 "Elevation y at which the hydrostatic pressure is zero. Needs "
                                 "gravity.",
                                 "no water table"});
  option(m.saturation, Quantity{"saturation", "1", fraction, Need::optional,
                                "Share of the pores that is filled."});
  option(m.crack_pressure, Quantity{"crack_pressure", "Pa", finite, Need::optional,
                                    "Pressure in the fractures.", "as in the pores"});
  option(m.crack_saturation, Quantity{"crack_saturation", "1", fraction, Need::optional,
                                      "Share of the fractures that is filled.", "as in the pores"});
}

}  // namespace percolith::case_file
