// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/error.hpp"
#include "percolith/seepage/pore.hpp"
#include "percolith/simulation/frames.hpp"

#include <fmt/format.h>

namespace percolith::simulation {
namespace {

using mesh::Index;

std::vector<Point> points_of(const Probe& probe) {
  if (probe.point) {
    return {{(*probe.point)[0], (*probe.point)[1]}};
  }
  const auto from = probe.from.value_or(std::array<double, 2>{});
  const auto to = probe.to.value_or(std::array<double, 2>{});
  std::vector<Point> points;
  for (int i = 0; i < probe.points; ++i) {
    const double f = probe.points > 1 ? static_cast<double>(i) / (probe.points - 1) : 0.0;
    points.push_back({from[0] + f * (to[0] - from[0]), from[1] + f * (to[1] - from[1])});
  }
  return points;
}

double between(const std::vector<double>& field, const std::array<Index, 2>& ends,
               double fraction) {
  return (1.0 - fraction) * field[at(ends[0])] + fraction * field[at(ends[1])];
}

}  // namespace

ProbeReader::ProbeReader(const std::map<std::string, Probe>& probes, const seepage::Model& model,
                         double head_datum)
    : head_datum_(head_datum) {
  if (probes.empty()) {
    return;
  }
  const mesh::TriangleFinder finder(model.mesh);
  for (const auto& [name, probe] : probes) {
    Located located{name, probe.in, {}};
    const std::vector<Point> points = points_of(probe);
    for (const Point& p : points) {
      if (probe.in == Domain::crack) {
        const auto place = nearest_joint(model.mesh, model.cracks.broken_joints(), p);
        if (place && place->distance <= 0.5 * model.mesh.joint_length(place->joint)) {
          located.targets.push_back({p, {}, *place});
        }
      } else if (const auto place = finder.find(p)) {
        located.targets.push_back({p, *place, {}});
      }
    }
    if (located.targets.empty()) {
      const bool line = !probe.point;
      throw InputError({{},
                        fmt::format("probe.{}.{}", name, line ? "from" : "point"),
                        "",
                        probe.in == Domain::crack ? "no open crack is near"
                        : line                    ? "the line lies outside of the rock"
                                                  : "the point lies outside of the rock",
                        probe.in == Domain::crack ? "places on a fracture, within half an edge"
                                                  : "places inside the mesh"});
    }
    if (located.targets.size() < points.size()) {
      warnings_.push_back(fmt::format("probe.{}: {} of {} points lie {} and are left out", name,
                                      points.size() - located.targets.size(), points.size(),
                                      probe.in == Domain::crack ? "too far from any open crack"
                                                                : "outside of the rock"));
    }
    probes_.push_back(std::move(located));
  }
}

ProbeRow ProbeReader::matrix_row(const seepage::Model& model, const Target& target) const {
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
  const double specific_weight = model.fluid.density * model.gravity;
  if (specific_weight > 0.0) {
    row.values.push_back(pressure / specific_weight + (target.place.y - head_datum_));
  }
  row.values.insert(row.values.end(), {saturation, flux.x, flux.y});
  return row;
}

ProbeRow ProbeReader::crack_row(const seepage::Model& model, const Target& target) const {
  const auto& [joint, fraction, distance] = target.in_crack;
  const auto& ends = model.mesh.joint[at(joint)].vertex;
  const double pressure = between(model.state.crack_pressure, ends, fraction);
  ProbeRow row{target.place, {pressure}};
  const double specific_weight = model.fluid.density * model.gravity;
  if (specific_weight > 0.0) {
    const double y = (1.0 - fraction) * model.mesh.vertex[at(ends[0])].y +
                     fraction * model.mesh.vertex[at(ends[1])].y;
    row.values.push_back(pressure / specific_weight + (y - head_datum_));
  }
  const Point along = model.mesh.vertex[at(ends[1])] - model.mesh.vertex[at(ends[0])];
  const Point flux = (crack_flow(model, joint) / model.mesh.joint_length(joint)) * along;
  row.values.insert(row.values.end(), {between(model.state.crack_saturation, ends, fraction),
                                       model.crack.aperture[at(joint)], flux.x, flux.y});
  return row;
}

std::vector<ProbeSample> ProbeReader::read(const seepage::Model& model) const {
  std::vector<ProbeSample> samples;
  for (const Located& probe : probes_) {
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
    for (const Target& target : probe.targets) {
      sample.rows.push_back(crack ? crack_row(model, target) : matrix_row(model, target));
    }
    samples.push_back(std::move(sample));
  }
  return samples;
}

}  // namespace percolith::simulation
