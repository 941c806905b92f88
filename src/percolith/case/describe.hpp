// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/describe_conditions.hpp"
#include "percolith/case/describe_mechanics.hpp"
#include "percolith/case/describe_model.hpp"
#include "percolith/case/describe_run.hpp"

namespace percolith::case_file {

/// The format of case files this version reads.
inline constexpr int current_format = 1;

/// Lists every option of a case file to a visitor, in the order in which they are shown.
template <class V>
void describe(V& option, simulation::Setup& m) {
  option(m.format, Count{"format", current_format, current_format, Need::required,
                         "Format of the case file; this version reads 1."});
  option(m.title, Text{"title", Need::optional, "One line that says what the case is."});
  option(m.mesh, Table{"mesh", "The mesh or geometry."});
  option(m.model, Table{"model", "What is computed, gravity and the laws of flow."});
  option(m.fluid, Table{"fluid", "The fluid in pores and fractures; the defaults are water."});
  option(m.material,
         NamedTables{"material", "A rock and the regions made of it. Every region needs "
                                 "one."});
  option(m.fracture, NamedTables{"fracture", "A kind of fracture and the curves it lies on."});
  option(m.new_cracks, Table{"new_cracks", "Flow in cracks that open during the run."});
  option(m.boundary,
         NamedTables{"boundary",
                     "A condition on a part of the boundary: of the flow at most one of "
                     "pressure, head, flux and seepage_face, in seepage exactly one; "
                     "of mechanics any that do not contradict each other."});
  option(m.source, NamedTables{"source", "Fluid brought in at a point or along fractures: exactly "
                                         "one of rate and pressure."});
  option(m.body, NamedTables{"body", "A part of the model that moves in its own way: a rigid "
                                     "platen, or a body that is thrown."});
  option(m.point_force, NamedTables{"point_force", "A force on one vertex."});
  option(m.in_situ, Table{"in_situ", "The stress of the rock at time zero: stress + gradient (y - "
                                     "datum). Without the table it is zero."});
  option(m.excavation, NamedTables{"excavation", "Regions that are taken out of the rock."});
  option(m.damping, Table{"damping", "What takes energy out of the motion."});
  option(m.contact, Table{"contact", "Contact between faces that meet, and its friction."});
  option(m.initial,
         Table{"initial", "The state at time zero: at most one of pressure, head, "
                          "water_table and steady. Needs a time.scheme other than steady."});
  option(m.time, Table{"time", "How the run advances in time."});
  option(m.output, Table{"output", "When and what is written."});
  option(m.probe, NamedTables{"probe", "Values written over time, at a point or on a line."});
}

}  // namespace percolith::case_file
