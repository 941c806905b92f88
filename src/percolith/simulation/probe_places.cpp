// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/probe_places.hpp"

#include "percolith/core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
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
  constexpr double near_enough = 0.5;  // of the length of a joint
  const bool are_in_cracks = std::any_of(probes.begin(), probes.end(), [](const auto& entry) {
    return entry.second.in == Domain::crack;
  });
  const mesh::TriangleFinder finder(mesh);
  const mesh::JointFinder joints(mesh, are_in_cracks ? cracks : std::span<const mesh::Index>{},
                                 near_enough);
  for (const auto& [name, probe] : probes) {
    LocatedProbe located{name, probe.in, {}};
    const std::vector<Point> points = points_of(probe);
    for (const Point& p : points) {
      if (probe.in == Domain::crack) {
        std::vector<mesh::PlaceOnJoint> near = joints.near(p);
        if (!near.empty()) {
          located.targets.push_back({p, {}, std::move(near)});
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
                        probe.in == Domain::crack ? "no joint is near that is open or may open"
                        : line                    ? "the line lies outside of the rock"
                                                  : "the point lies outside of the rock",
                        probe.in == Domain::crack
                            ? "places within half an edge of a fracture or, in rock that breaks, "
                              "of any joint"
                            : "places inside the mesh"});
    }
    if (located.targets.size() < points.size()) {
      places.warnings.push_back(
          fmt::format("probe.{}: {} of {} points lie {} and are left out", name,
                      points.size() - located.targets.size(), points.size(),
                      probe.in == Domain::crack ? "too far from any joint that is open or may open"
                                                : "outside of the rock"));
    }
    places.probes.push_back(std::move(located));
  }
  return places;
}

}  // namespace percolith::simulation
