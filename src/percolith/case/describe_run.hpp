// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/option.hpp"
#include "percolith/simulation/setup.hpp"

// The options of time stepping and output.
namespace percolith::case_file {

template <class V>
void describe(V& option, simulation::Stepping& m) {
  using simulation::Scheme;
  option(m.scheme, Choice<Scheme>{"scheme",
                                  {{Scheme::implicit, "implicit"},
                                   {Scheme::explicit_, "explicit"},
                                   {Scheme::steady, "steady"},
                                   {Scheme::quasi_static, "quasi_static"}},
                                  "implicit takes long, error-controlled steps; explicit takes "
                                  "small ones below its stability limit; steady finds the state "
                                  "that no longer changes. Mechanics is always explicit; coupled "
                                  "runs are explicit, or, for slow injection, quasi_static: a rock "
                                  "in balance with the flow at every step.",
                                  "explicit"});
  option(m.end, Quantity{"end", "s", positive, Need::optional,
                         "Time at which the run ends. Needs a scheme other than steady.",
                         "required unless steady"});
  option(m.step, Quantity{"step", "s", positive, Need::optional,
                          "Fixed step (implicit, quasi_static), or upper bound of the step "
                          "(explicit).",
                          "chosen by the program"});
  option(m.initial_step, Quantity{"initial_step", "s", positive, Need::optional,
                                  "First step. Needs implicit or quasi_static without step.",
                                  "chosen by the program"});
  option(m.maximum_step,
         Quantity{"maximum_step", "s", positive, Need::optional,
                  "Upper bound of the step. Needs implicit or quasi_static without step.",
                  "no bound; a twentieth of the run where it is quasi_static"});
  option(m.tolerance, Quantity{"tolerance", "1", Bounds{0.0, 1.0, false, false}, Need::optional,
                               "Error allowed in one step over the range of pressure (implicit "
                               "without step); change of the pressures between two iterations, "
                               "over the largest, that ends a quasi_static step."});
  option(
      m.balance_tolerance,
      Quantity{"balance_tolerance", "1", Bounds{0.0, 1.0, false, false}, Need::optional,
               "Unbalanced force that a quasi_static step may leave, over the force of the fluid "
               "on the faces of cracks or, without cracks, the internal forces; at most half of "
               "tolerance, since pressures do not settle further than forces do.",
               "a tenth of tolerance"});
  option(m.safety, Quantity{"safety", "1", positive_fraction, Need::optional,
                            "Share of the stability limit that is used. Needs explicit."});
  using simulation::PoreFlow;
  option(m.pore_flow,
         Choice<PoreFlow>{"pore_flow",
                          {{PoreFlow::explicit_, "explicit"}, {PoreFlow::implicit, "implicit"}},
                          "How fluid flows through the pores in each step of an explicit coupled "
                          "run: explicit in as many steps as the pores need, or implicit together "
                          "with the cracks, in one. Cracks are always implicit."});
  option(m.stop_ratio, Quantity{"stop_ratio", "1", Bounds{0.0, 1.0, false, false}, Need::optional,
                                "Ends the run early. In mechanics: unbalanced force over internal "
                                "forces below which the rock is at rest; in coupled physics the "
                                "pressures in the cracks must rest as well, and no rate may go on "
                                "to the end. In seepage: what pores and cracks store and give up, "
                                "over what flows through, below which the flow is steady. Needs a "
                                "scheme other than steady.",
                                "the run goes on to its end"});
  option(m.mass_scaling_step,
         Quantity{"mass_scaling_step", "s", positive, Need::optional,
                  "Step that triangles with a lower limit are made to bear, by more mass.",
                  "no mass is added"});
}

template <class V>
void describe(V& option, simulation::Output& m) {
  option(m.times, Quantity{"times", "s", not_negative, Need::optional,
                           "Times at which fields and probes are written, besides start and end."});
  option(m.interval,
         Quantity{"interval", "s", positive, Need::optional,
                  "Time between two outputs of fields and probes.", "only start, times and end"});
  option(m.fields, Flag{"fields", "Whether the field series is written."});
  option(m.history_interval,
         Quantity{"history_interval", "s", positive, Need::optional,
                  "Time between two rows of the history.",
                  "a row at every implicit step, or at every thousandth of an explicit run"});
  option(m.checkpoint_interval,
         Quantity{"checkpoint_interval", "s", positive, Need::optional,
                  "Time of the simulation between two checkpoints, from which percolith run "
                  "--resume goes on.",
                  "only those of checkpoint_wall_interval"});
  option(m.checkpoint_wall_interval,
         Quantity{"checkpoint_wall_interval", "s", not_negative, Need::optional,
                  "Time on the wall between two checkpoints, or a hundred times as long as it "
                  "takes to write one, if that is longer; 0: none but those of "
                  "checkpoint_interval. A run that is stopped by a signal always leaves one."});
}

template <class V>
void describe(V& option, simulation::Probe& m) {
  using simulation::Domain;
  option(m.point, Quantity{"point", "m", finite, Need::optional, "Place [x, y] of a point probe.",
                           "no point"});
  option(m.from, Quantity{"from", "m", finite, Need::optional,
                          "First point [x, y] of a line probe.", "no line"});
  option(m.to, Quantity{"to", "m", finite, Need::optional, "Last point [x, y] of a line probe.",
                        "no line"});
  option(m.points, Count{"points", 2, 1000000, Need::optional,
                         "Number of points on the line, both ends included. Needs from and to."});
  option(m.in, Choice<Domain>{"in",
                              {{Domain::matrix, "matrix"}, {Domain::crack, "crack"}},
                              "Whether the matrix or the nearest crack is probed."});
}

}  // namespace percolith::case_file
