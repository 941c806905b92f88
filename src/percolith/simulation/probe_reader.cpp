// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/pore.hpp"
#include "percolith/simulation/frames.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace percolith::simulation {
namespace {

using mesh::Index;

double between(const std::vector<double>& field, const std::array<Index, 2>& ends,
               double fraction) {
  return (1.0 - fraction) * field[at(ends[0])] + fraction * field[at(ends[1])];
}

/// The head, m, behind the pressure that a row begins with, at an elevation above the datum, m; of
/// a fluid that has weight.
void add_head(const seepage::Model& model, double elevation, ProbeRow& row) {
  const double specific_weight = model.fluid.density * model.gravity;
  if (specific_weight > 0.0) {
    row.values.push_back(row.values.front() / specific_weight + elevation);
  }
}

/// Where a probe stands in a crack that is open now, or null.
const mesh::PlaceOnJoint* open_place(const seepage::Model& model, const ProbeTarget& target) {
  const auto open =
      std::find_if(target.in_crack.begin(), target.in_crack.end(),
                   [&](const auto& place) { return model.cracks.is_broken(place.joint); });
  return open == target.in_crack.end() ? nullptr : &*open;
}

/// Points of probes that no crack has reached are told of before the run.
std::vector<std::string> dry_warnings(const seepage::Model& model,
                                      const std::vector<LocatedProbe>& probes) {
  std::vector<std::string> warnings;
  for (const LocatedProbe& probe : probes) {
    const auto dry =
        std::count_if(probe.targets.begin(), probe.targets.end(), [&](const ProbeTarget& target) {
          return open_place(model, target) == nullptr;
        });
    if (probe.in == Domain::crack && dry > 0) {
      warnings.push_back(fmt::format(
          "probe.{}: no crack is open at {} of {} points when the run starts; they read dry "
          "(saturation and aperture 0) until one opens within half an edge",
          probe.name, dry, probe.targets.size()));
    }
  }
  return warnings;
}

}  // namespace

ProbeReader::ProbeReader(const std::map<std::string, Probe>& probes, const seepage::Model& model,
                         std::span<const Index> cracks, double head_datum)
    : places_(locate_probes(probes, model.mesh, cracks)), head_datum_(head_datum) {
  const std::vector<std::string> dry = dry_warnings(model, places_.probes);
  places_.warnings.insert(places_.warnings.end(), dry.begin(), dry.end());
}

ProbeRow ProbeReader::matrix_row(const seepage::Model& model, const ProbeTarget& target) const {
  const auto& [triangle, weight] = target.in_matrix;
  double pressure = 0.0;
  double saturation = 0.0;
  for (Index k = 0; k < 3; ++k) {
    const auto corner = at(mesh::corner_of(triangle, k));
    pressure += weight[at(k)] * model.state.pressure[corner];
    saturation += weight[at(k)] * model.state.saturation[corner];
  }
  const Point flux =
      seepage::darcy_flux(model.mesh.triangle_points(triangle), triangle_flows(model, triangle));
  ProbeRow row{target.place, {pressure}};
  add_head(model, target.place.y - head_datum_, row);
  row.values.insert(row.values.end(), {saturation, flux.x, flux.y});
  return row;
}

ProbeRow ProbeReader::dry_row(const seepage::Model& model, const ProbeTarget& target) const {
  ProbeRow row{target.place, {model.reference_pressure()}};
  add_head(model, target.place.y - head_datum_, row);
  row.values.insert(row.values.end(), {0.0, 0.0, 0.0, 0.0});
  return row;
}

ProbeRow ProbeReader::crack_row(const seepage::Model& model, const ProbeTarget& target) const {
  const mesh::PlaceOnJoint* const place = open_place(model, target);
  if (place == nullptr) {
    return dry_row(model, target);
  }
  const auto& [joint, fraction, distance] = *place;
  const auto& ends = model.mesh.joint[at(joint)].vertex;
  const double pressure = between(model.state.crack_pressure, ends, fraction);
  ProbeRow row{target.place, {pressure}};
  const double y = (1.0 - fraction) * model.mesh.vertex[at(ends[0])].y +
                   fraction * model.mesh.vertex[at(ends[1])].y;
  add_head(model, y - head_datum_, row);
  const Point along = model.mesh.vertex[at(ends[1])] - model.mesh.vertex[at(ends[0])];
  const Point flux = (crack_flow(model, joint) / model.mesh.joint_length(joint)) * along;
  row.values.insert(row.values.end(), {between(model.state.crack_saturation, ends, fraction),
                                       model.crack.aperture[at(joint)], flux.x, flux.y});
  return row;
}

std::vector<ProbeSample> ProbeReader::read(const seepage::Model& model) const {
  std::vector<ProbeSample> samples;
  for (const LocatedProbe& probe : places_.probes) {
    const bool crack = probe.in == Domain::crack;
    ProbeSample sample{probe.name, {"pressure_Pa"}, {}};
    if (model.gravity > 0.0) {
      sample.columns.push_back("head_m");
    }
    const std::vector<std::string> more =
        crack ? std::vector<std::string>{"saturation", "aperture_m", "flux_x_m2_per_s",
                                         "flux_y_m2_per_s"}
              : std::vector<std::string>{"saturation", "flux_x_m_per_s", "flux_y_m_per_s"};
    sample.columns.insert(sample.columns.end(), more.begin(), more.end());
    for (const ProbeTarget& target : probe.targets) {
      sample.rows.push_back(crack ? crack_row(model, target) : matrix_row(model, target));
    }
    samples.push_back(std::move(sample));
  }
  return samples;
}

}  // namespace percolith::simulation
