// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/solid_boundaries.hpp"
#include "percolith/simulation/solid_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace percolith::simulation {
namespace {

using mesh::Index;

/// Largest share of the work done on the rock, and of the energy it had, that no term accounts for.
double energy_error(const mechanics::EnergyBalance& b) {
  const double scale =
      std::max({std::abs(b.external), std::abs(b.gravity), std::abs(b.fluid), b.kinetic, b.elastic,
                b.joint, b.fracture + b.friction + b.damping + b.absorbed});
  return scale > 0.0 ? std::abs(b.residual) / scale : 0.0;
}

/// `is_wet`: whether there is fluid that does work.
template <class Named>
void add_energies(const mechanics::EnergyBalance& b, bool is_wet, std::vector<Named>& values) {
  values.insert(values.end(), {{"kinetic_J_per_m", b.kinetic},
                               {"elastic_J_per_m", b.elastic},
                               {"joint_J_per_m", b.joint},
                               {"fracture_J_per_m", b.fracture},
                               {"contact_J_per_m", b.contact},
                               {"friction_J_per_m", b.friction},
                               {"damping_J_per_m", b.damping},
                               {"absorbed_J_per_m", b.absorbed},
                               {"gravity_J_per_m", b.gravity},
                               {"external_work_J_per_m", b.external}});
  if (is_wet) {
    values.push_back({"fluid_work_J_per_m", b.fluid});
  }
  values.push_back({"residual_J_per_m", b.residual});
}

void add_boundaries(const std::vector<BoundaryState>& states, std::vector<NamedValue>& values) {
  for (const BoundaryState& state : states) {
    values.insert(values.end(), {{state.name + ".reaction_x_N_per_m", state.force.x},
                                 {state.name + ".reaction_y_N_per_m", state.force.y},
                                 {state.name + ".displacement_x_m", state.displacement.x},
                                 {state.name + ".displacement_y_m", state.displacement.y}});
  }
}

void note_peaks(const std::vector<BoundaryState>& states, double time,
                std::vector<PeakReaction>& peaks) {
  const bool first = peaks.empty();
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (first) {
      peaks.push_back({states[i].name, 0.0, 0.0, time, time});
    }
    PeakReaction& peak = peaks[i];
    if (std::abs(states[i].force.x) > std::abs(peak.x)) {
      peak.x = states[i].force.x;
      peak.x_time = time;
    }
    if (std::abs(states[i].force.y) > std::abs(peak.y)) {
      peak.y = states[i].force.y;
      peak.y_time = time;
    }
  }
}

bool is_wet(const SolidRun& run) {
  return !run.dynamics.model().pores.biot.empty();
}

std::int64_t broken_by(const SolidRun& run, BreakMode mode) {
  return std::count(run.broken.mode.begin(), run.broken.mode.end(),
                    static_cast<std::int32_t>(mode));
}

}  // namespace

std::vector<FragmentRow> fragment_rows(const SolidRun& run) {
  const mechanics::Model& model = run.dynamics.model();
  const mechanics::Motion& m = model.motion;
  std::vector<FragmentRow> rows(run.fragments.area.size());
  std::vector<double> mass(rows.size(), 0.0);
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    const Index number = run.fragments.number[at(t)];
    if (number == mesh::none) {
      continue;
    }
    FragmentRow& row = rows[at(number)];
    row.number = number;
    ++row.triangles;
    const double area = model.mesh.area(t);
    const double weight = 1.0 / model.triangles.inverse_mass[at(t)];
    row.area += area;
    mass[at(number)] += 3.0 * weight;
    for (Index k = 0; k < 3; ++k) {
      const Index c = mesh::corner_of(t, k);
      row.centre =
          row.centre + area / 3.0 * (model.mesh.place_of(c) + Point{m.ux[at(c)], m.uy[at(c)]});
      row.velocity = row.velocity + weight * Point{m.vx[at(c)], m.vy[at(c)]};
    }
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].centre = (1.0 / rows[i].area) * rows[i].centre;
    rows[i].velocity = (1.0 / mass[i]) * rows[i].velocity;
  }
  return rows;
}

HistoryRow solid_history_row(SolidRun& run, double step_size) {
  if (run.fragments_stale) {
    run.fragments = mechanics::find_fragments(run.dynamics.model());
    run.fragments_stale = false;
  }
  run.deepest_overlap = std::max(run.deepest_overlap, run.dynamics.contact().deepest());
  HistoryRow row;
  row.time = run.dynamics.model().motion.time;
  row.step = run.summary.steps;
  row.step_size = step_size;
  row.has_flow = false;
  add_energies(run.dynamics.energy(run.execution), is_wet(run), row.mechanics);
  row.mechanics.insert(row.mechanics.end(),
                       {{"broken_joints", static_cast<double>(run.broken.count)},
                        {"fragments", static_cast<double>(run.fragments.area.size())},
                        {"unbalanced_ratio", run.dynamics.unbalanced_ratio()}});
  const std::vector<BoundaryState> states = boundary_states(run.setup, run.dynamics);
  add_boundaries(states, row.mechanics);
  note_peaks(states, row.time, run.summary.peak_reactions);
  return row;
}

double b_value(std::span<const double> magnitudes) {
  constexpr std::size_t fewest = 20;
  constexpr double bin = 0.1;
  std::map<std::int64_t, std::size_t> bins;
  std::size_t finite = 0;
  for (const double m : magnitudes) {
    if (std::isfinite(m)) {
      ++bins[std::llround(m / bin)];
      ++finite;
    }
  }
  if (finite < fewest) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const auto fullest = std::max_element(
      bins.begin(), bins.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  const double least = bin * static_cast<double>(fullest->first);
  double sum = 0.0;
  double count = 0.0;
  for (const auto& [number, events] : bins) {
    if (number >= fullest->first) {
      sum += bin * static_cast<double>(number) * static_cast<double>(events);
      count += static_cast<double>(events);
    }
  }
  return std::log10(std::exp(1.0)) / (sum / count - least + 0.5 * bin);
}

double solid_energy_error(const SolidRun& run) {
  return energy_error(run.dynamics.energy(run.execution));
}

Summary solid_summary(const SolidRun& run) {
  Summary summary = run.summary;
  const mechanics::Dynamics& dynamics = run.dynamics;
  summary.end_time = dynamics.model().motion.time;
  summary.wall_time = {run.execution.wall_time().begin(), run.execution.wall_time().end()};
  StateHash hash;
  dynamics.add_to(hash);
  summary.state_hash = hash.text();
  const mechanics::EnergyBalance balance = dynamics.energy(run.execution);
  add_energies(balance, is_wet(run), summary.mechanics);
  const mechanics::Fragments fragments = mechanics::find_fragments(dynamics.model());
  const double largest = fragments.area.empty()
                             ? 0.0
                             : *std::max_element(fragments.area.begin(), fragments.area.end());
  const double area = std::accumulate(fragments.area.begin(), fragments.area.end(), 0.0);
  summary.mechanics.insert(
      summary.mechanics.end(),
      {{"energy_error", energy_error(balance)},
       {"broken_joints", run.broken.count},
       {"broken_joints_tensile", broken_by(run, BreakMode::tensile)},
       {"broken_joints_shear", broken_by(run, BreakMode::shear)},
       {"broken_joints_mixed", broken_by(run, BreakMode::mixed)},
       {"closed_joints", static_cast<std::int64_t>(dynamics.model().closed.size())},
       {"fragments", static_cast<std::int64_t>(fragments.area.size())},
       {"fragment_area_m2", area},
       {"largest_fragment_area_m2", largest},
       {"deepest_overlap_m", std::max(run.deepest_overlap, dynamics.contact().deepest())},
       {"unbalanced_ratio", dynamics.unbalanced_ratio()},
       {"added_mass_share", run.added_mass}});
  const double b = b_value(run.broken.magnitude);
  if (std::isfinite(b)) {
    summary.mechanics.emplace_back("b_value", b);
  }
  return summary;
}

std::vector<BreakEvent> note_events(SolidRun& run, const mechanics::Changes& changes,
                                    std::int64_t step) {
  std::vector<BreakEvent> events;
  const mechanics::Model& model = run.dynamics.model();
  for (const mechanics::Breakage& b : changes.broke) {
    BreakEvent event;
    event.time = b.time;
    event.step = step;
    event.place = model.mesh.middle_of(model.mesh.joint[at(b.joint)].vertex);
    event.mode = static_cast<BreakMode>(b.mode);
    event.length = b.length;
    event.released_energy = b.released;
    event.magnitude = 2.0 / 3.0 * (std::log10(b.released) - 4.8);
    event.material = run.kind_names[at(mechanics::owner_of(model, b.joint))];
    run.broken.mode[at(b.joint)] = static_cast<std::int32_t>(b.mode);
    run.broken.time[at(b.joint)] = b.time;
    run.broken.released[at(b.joint)] = b.released;
    run.broken.magnitude.push_back(event.magnitude);
    ++run.broken.count;
    events.push_back(std::move(event));
  }
  run.fragments_stale = run.fragments_stale || changes.any();
  return events;
}

}  // namespace percolith::simulation
