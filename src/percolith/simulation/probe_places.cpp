// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/probe_places.hpp"

#include "percolith/core/error.hpp"

#include <fmt/format.h>

#include <utility>

namespace percolith::simulation {
namespace {

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

}  // namespace

ProbePlaces locate_probes(const std::map<std::string, Probe>& probes, const mesh::Mesh& mesh,
                          std::span<const mesh::Index> cracks) {
  ProbePlaces places;
  if (probes.empty()) {
    return places;
  }
  const mesh::TriangleFinder finder(mesh);
  for (const auto& [name, probe] : probes) {
    LocatedProbe located{name, probe.in, {}};
    const std::vector<Point> points = points_of(probe);
    for (const Point& p : points) {
      if (probe.in == Domain::crack) {
        constexpr double near = 0.5;  // of the length of a joint
        std::vector<mesh::PlaceOnJoint> joints = joints_near(mesh, cracks, p, near);
        if (!joints.empty()) {
          located.targets.push_back({p, {}, std::move(joints)});
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
      places.warnings.push_back(fmt::format(
          "probe.{}: {} of {} points lie {} and are left out", name,
          points.size() - located.targets.size(), points.size(),
          probe.in == Domain::crack ? "too far from any open crack" : "outside of the rock"));
    }
    places.probes.push_back(std::move(located));
  }
  return places;
}

}  // namespace percolith::simulation
