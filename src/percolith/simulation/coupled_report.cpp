// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/pore.hpp"
#include "percolith/simulation/balance.hpp"
#include "percolith/simulation/coupled_run.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace percolith::simulation {
namespace {

using mesh::Index;

/// What the cracks have come to.
struct CrackTotals {
  double length = 0.0;         ///< m
  double filled_length = 0.0;  ///< m: between nodes that are full
  double volume = 0.0;         ///< m2
  double aperture = 0.0;       ///< m, mean over the length of the hydraulic one
};

CrackTotals totals_of(const seepage::Model& model) {
  CrackTotals totals;
  for (const Index j : model.cracks.broken_joints()) {
    const double length = model.mesh.joint_length(j);
    totals.length += length;
    totals.aperture += length * model.crack.aperture[at(j)];
    const auto& ends = model.mesh.joint[at(j)].vertex;
    const bool is_full = model.state.crack_saturation[at(ends[0])] >= 1.0 &&
                         model.state.crack_saturation[at(ends[1])] >= 1.0;
    totals.filled_length += is_full ? length : 0.0;
  }
  for (const Index v : model.cracks.open_nodes()) {
    totals.volume += model.crack.void_volume[at(v)];
  }
  totals.aperture = totals.length > 0.0 ? totals.aperture / totals.length : 0.0;
  return totals;
}

/// Mean pressure at the nodes in cracks that each source feeds, by its shares, Pa.
std::vector<NamedValue> source_pressures(const seepage::Model& model) {
  std::map<Index, std::pair<double, double>> sums;  // by condition: pressure, share
  const auto add = [&](const seepage::NodeCondition& c, double share) {
    if (model.conditions.name[at(c.condition)].starts_with("source.") &&
        model.cracks.is_open(c.place)) {
      auto& [pressure, shares] = sums[c.condition];
      pressure += share * model.state.crack_pressure[at(c.place)];
      shares += share;
    }
  };
  for (const seepage::NodeCondition& c : model.conditions.crack.rate) {
    add(c, c.factor);
  }
  for (const seepage::NodeCondition& c : model.conditions.crack.pressure) {
    add(c, 1.0);
  }
  std::vector<NamedValue> pressures;
  pressures.reserve(sums.size());
  for (const auto& [condition, sum] : sums) {
    pressures.emplace_back(model.conditions.name[at(condition)],
                           sum.second > 0.0 ? sum.first / sum.second : 0.0);
  }
  return pressures;
}

void note_peaks(const std::vector<NamedValue>& pressures, double time,
                std::vector<PeakPressure>& peaks) {
  for (const auto& [name, pressure] : pressures) {
    const auto known = std::find_if(peaks.begin(), peaks.end(), [&, &source = name](const auto& p) {
      return p.name == source;
    });
    if (known == peaks.end()) {
      peaks.push_back({name, pressure, time});
    } else if (pressure > known->pressure) {
      known->pressure = pressure;
      known->time = time;
    }
  }
}

void add_injected(const seepage::Model& model, std::vector<NamedValue>& values) {
  for (std::size_t i = 0; i < model.let_in.size(); ++i) {
    values.emplace_back(model.conditions.name[i] + ".volume_m2", model.let_in[i].total());
  }
}

}  // namespace

double crack_fluid(const seepage::Model& model) {
  double sum = 0.0;
  for (const Index v : model.cracks.open_nodes()) {
    sum += model.crack.void_volume[at(v)] +
           (model.state.crack_content[at(v)] + model.state.crack_content_carry[at(v)]);
  }
  return sum;
}

HistoryRow coupled_history_row(SolidRun& rock, const WaterRun& water, double leaked,
                               double step_size) {
  HistoryRow row = solid_history_row(rock, step_size);
  HistoryRow flow =
      history_row(water.model, mass_balance(water.model, water.in_place_at_start, rock.execution));
  flow.time = row.time;
  flow.step = row.step;
  flow.step_size = row.step_size;
  flow.mechanics = std::move(row.mechanics);
  const CrackTotals cracks = totals_of(water.model);
  flow.mechanics.insert(flow.mechanics.end(), {{"crack_length_m", cracks.length},
                                               {"filled_crack_length_m", cracks.filled_length},
                                               {"mean_aperture_m", cracks.aperture},
                                               {"crack_volume_m2", cracks.volume},
                                               {"crack_fluid_m2", crack_fluid(water.model)},
                                               {"leaked_m2", leaked}});
  const std::vector<NamedValue> pressures = source_pressures(water.model);
  for (const auto& [name, pressure] : pressures) {
    flow.mechanics.emplace_back(name + ".pressure_Pa", pressure);
  }
  note_peaks(pressures, flow.time, rock.summary.peak_pressures);
  add_injected(water.model, flow.mechanics);
  return flow;
}

MatrixFrame coupled_matrix_frame(const SolidRun& rock, const WaterRun& water) {
  MatrixFrame frame = solid_matrix_frame(rock);
  const mechanics::Model& solid = rock.dynamics.model();
  const seepage::Model& model = water.model;
  std::vector<std::uint8_t> known(frame.points.size(), 0);
  frame.pressure.assign(frame.points.size(), 0.0);
  frame.saturation.assign(frame.points.size(), 0.0);
  const double weight = model.fluid.density * model.gravity;
  std::size_t shown = 0;
  for (Index t = 0; t < solid.mesh.triangles(); ++t) {
    if (solid.triangles.inverse_mass[at(t)] == 0.0) {
      continue;
    }
    for (Index k = 0; k < 3; ++k) {
      const auto point = at(frame.triangles[shown][at(k)]);
      if (std::exchange(known[point], 1) == 0) {
        const auto corner = at(mesh::corner_of(t, k));
        frame.pressure[point] = model.state.pressure[corner];
        frame.saturation[point] = model.state.saturation[corner];
      }
    }
    frame.flux.push_back(
        seepage::darcy_flux(model.mesh.triangle_points(t), triangle_flows(model, t)));
    ++shown;
  }
  if (weight > 0.0) {
    for (std::size_t i = 0; i < frame.points.size(); ++i) {
      frame.head.push_back(frame.pressure[i] / weight +
                           (frame.points[i].y - rock.setup.model.head_datum));
    }
  }
  return frame;
}

CrackFrame coupled_crack_frame(const SolidRun& rock, const WaterRun& water) {
  const seepage::Model& model = water.model;
  std::vector<Index> joints;
  std::vector<Index> vertices;
  CrackFrame frame = solid_crack_frame(rock, &joints, &vertices);
  const double weight = model.fluid.density * model.gravity;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto v = at(vertices[i]);
    const bool open = model.cracks.is_open(vertices[i]);
    frame.pressure.push_back(open ? model.state.crack_pressure[v] : model.reference_pressure());
    frame.saturation.push_back(open ? model.state.crack_saturation[v] : 0.0);
    if (weight > 0.0) {
      frame.head.push_back(frame.pressure.back() / weight +
                           (frame.points[i].y - rock.setup.model.head_datum));
    }
  }
  std::vector<std::int32_t> wet;
  for (const Index j : joints) {
    const bool open = model.cracks.is_broken(j);
    wet.push_back(open ? 1 : 0);
    frame.aperture.push_back(open ? model.crack.aperture[at(j)] : 0.0);
    frame.flux.push_back(open ? crack_flow(model, j) : 0.0);
  }
  frame.cell_fields.push_back({"wet", std::move(wet)});
  return frame;
}

std::vector<ProbeSample> read_coupled_probes(const SolidRun& rock, const WaterRun& water) {
  std::vector<ProbeSample> samples = water.probes.read(water.model);
  for (const ProbeSample& solid : read_solid_probes(rock)) {
    const auto flow = std::find_if(samples.begin(), samples.end(),
                                   [&](const ProbeSample& s) { return s.name == solid.name; });
    flow->columns.insert(flow->columns.end(), solid.columns.begin(), solid.columns.end());
    for (std::size_t i = 0; i < flow->rows.size(); ++i) {
      auto& values = flow->rows[i].values;
      values.insert(values.end(), solid.rows[i].values.begin(), solid.rows[i].values.end());
    }
  }
  return samples;
}

}  // namespace percolith::simulation
