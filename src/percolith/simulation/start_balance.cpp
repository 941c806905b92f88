// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/start_balance.hpp"

#include "percolith/core/quantity_text.hpp"
#include "percolith/simulation/groups.hpp"
#include "percolith/simulation/holds_rock.hpp"
#include "percolith/simulation/solid_build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace percolith::simulation {
namespace {

using mesh::Index;

/// Shares beyond which a lack of balance is told of: of the in-situ stress at the edge, and of the
/// largest one.
constexpr double much_at_edge = 0.1;
constexpr double much_at_edges = 0.01;
constexpr double much_of_weight = 0.05;

double size_of(const Point& p) {
  return std::sqrt(dot(p, p));
}

Index edges_of(const mesh::Mesh& mesh) {
  return static_cast<Index>(mesh.boundary.size());
}

Point along_edge(const mesh::Mesh& mesh, Index e) {
  const mesh::BoundaryEdge& edge = mesh.boundary[at(e)];
  return mesh.vertex[at(edge.vertex[1])] - mesh.vertex[at(edge.vertex[0])];
}

/// Regions that are taken out from the start.
std::vector<Index> regions_taken_out(const Setup& setup, const mesh::Mesh& mesh) {
  std::vector<Index> regions;
  for (const auto& [name, excavation] : setup.excavation) {
    if (excavation.start <= 0.0) {
      const auto found = find_regions(mesh, excavation.regions, "excavation." + name + ".regions");
      regions.insert(regions.end(), found.begin(), found.end());
    }
  }
  return regions;
}

bool is_among(const std::vector<Index>& regions, Index region) {
  return std::find(regions.begin(), regions.end(), region) != regions.end();
}

/// Per boundary edge whether a condition holds it or its rock is taken out.
std::vector<std::uint8_t> kept_edges(const Setup& setup, const mesh::Mesh& mesh) {
  std::vector<std::uint8_t> kept(mesh.boundary.size(), 0);
  for (const auto& [name, b] : setup.boundary) {
    if (holds_rock(b)) {
      for (const Index e : boundary_edges(mesh, b.groups, "boundary." + name + ".groups")) {
        kept[at(e)] = 1;
      }
    }
  }
  const std::vector<Index> taken_out = regions_taken_out(setup, mesh);
  for (Index e = 0; e < edges_of(mesh); ++e) {
    if (is_among(taken_out, mesh.region[at(mesh::triangle_of(mesh.boundary[at(e)].corner[0]))])) {
      kept[at(e)] = 1;
    }
  }
  return kept;
}

/// Per boundary edge the size of the traction, Pa, with which the in-situ stress springs back.
std::vector<double> bare_tractions(const Setup& setup, const mesh::Mesh& mesh) {
  const std::vector<std::uint8_t> kept = kept_edges(setup, mesh);
  std::vector<double> bare(mesh.boundary.size(), 0.0);
  for (Index e = 0; e < edges_of(mesh); ++e) {
    if (kept[at(e)] == 0) {
      const Point along = along_edge(mesh, e);
      const Point middle = mesh.middle_of(mesh.boundary[at(e)].vertex);
      bare[at(e)] =
          size_of(in_situ_stress(*setup.in_situ, middle) * clockwise(along)) / size_of(along);
    }
  }
  return bare;
}

/// Larger principal in-situ stress in the plane at a place, by magnitude, Pa.
double principal_stress(const InSitu& in_situ, const Point& place) {
  const Tensor s = in_situ_stress(in_situ, place);
  return std::abs(0.5 * (s.xx + s.yy)) + std::hypot(0.5 * (s.xx - s.yy), s.xy);
}

/// The largest at the vertices of the rock, Pa.
double largest_stress(const InSitu& in_situ, const mesh::Mesh& mesh) {
  double largest = 0.0;
  for (const Point& p : mesh.vertex) {
    largest = std::max(largest, principal_stress(in_situ, p));
  }
  return largest;
}

/// Names of the curves with an edge of those that are told of, in quotes.
std::vector<std::string> curves_of(const mesh::Mesh& mesh, const std::vector<std::uint8_t>& told) {
  std::vector<std::string> names;
  for (const auto& [name, curve] : mesh.curves) {
    if (std::any_of(curve.boundary.begin(), curve.boundary.end(),
                    [&](Index e) { return told[at(e)] != 0; })) {
      names.push_back(name);
    }
  }
  return names;
}

/// A sentence, with a space before it, on conditions whose pressure only the fluid feels at edges
/// that are told of.
std::string pressure_advice(const Setup& setup, const mesh::Mesh& mesh,
                            const std::vector<std::uint8_t>& told) {
  std::string text;
  for (const auto& [name, b] : setup.boundary) {
    const std::string path = "boundary." + name;
    const std::vector<Index> edges = boundary_edges(mesh, b.groups, path + ".groups");
    if ((b.pressure || b.head) && !b.pressurised &&
        std::any_of(edges.begin(), edges.end(), [&](Index e) { return told[at(e)] != 0; })) {
      text += fmt::format(" What {} says of pressure the fluid alone feels: with pressurised = "
                          "true it presses on the rock as well.",
                          path);
    }
  }
  return text;
}

// Rock that nothing holds at all is the matter of a warning of the case file.
std::string edge_warning(const Setup& setup, const mesh::Mesh& mesh, double stress) {
  const std::vector<double> bare = bare_tractions(setup, mesh);
  std::vector<std::uint8_t> told(bare.size(), 0);
  double length = 0.0;
  Index worst = mesh::none;
  for (Index e = 0; e < edges_of(mesh); ++e) {
    const Point middle = mesh.middle_of(mesh.boundary[at(e)].vertex);
    if (bare[at(e)] >
        std::max(much_at_edges * stress, much_at_edge * principal_stress(*setup.in_situ, middle))) {
      told[at(e)] = 1;
      length += size_of(along_edge(mesh, e));
      worst = worst == mesh::none || bare[at(e)] > bare[at(worst)] ? e : worst;
    }
  }
  if (worst == mesh::none ||
      std::none_of(told.begin(), told.end(), [](std::uint8_t of) { return of == 0; })) {
    return {};
  }
  const Point p = mesh.middle_of(mesh.boundary[at(worst)].vertex);
  const std::vector<std::string> names = curves_of(mesh, told);
  return fmt::format(
      "in-situ stress ends at {:.4g} m of edges that do not hold it{}: up to {}, at ({:g}, {:g}). "
      "The rock springs out there when the run starts. A boundary with in_situ = true or a "
      "load holds it; an excavation lets it go slowly.{}",
      length, names.empty() ? "" : " (" + quoted_list(names) + ")", pressure_text(bare[at(worst)]),
      p.x, p.y, pressure_advice(setup, mesh, told));
}

/// Regions whose weight the rock does not feel: of rigid bodies, and what is not there from the
/// start.
std::vector<Index> regions_without_weight(const Setup& setup, const mesh::Mesh& mesh) {
  std::vector<Index> regions = regions_taken_out(setup, mesh);
  for (const auto& [name, body] : setup.body) {
    if (body.rigid) {
      const auto found = find_regions(mesh, body.regions, "body." + name + ".regions");
      regions.insert(regions.end(), found.begin(), found.end());
    }
  }
  return regions;
}

/// Density of the rock, kg/m3: the smallest, the largest, and the mean over its area.
struct Densities {
  double least = std::numeric_limits<double>::infinity(), most = 0.0, mean = 0.0;
};

Densities densities_of(const Setup& setup, const mesh::Mesh& mesh) {
  const std::vector<std::string> material = material_of_regions(setup, mesh);
  const std::vector<Index> without = regions_without_weight(setup, mesh);
  Densities found;
  double area = 0.0;
  double mass = 0.0;
  for (Index t = 0; t < mesh.triangles(); ++t) {
    const Index region = mesh.region[at(t)];
    if (!is_among(without, region)) {
      const double density = setup.material.at(material[at(region)]).solid.density;
      found.least = std::min(found.least, density);
      found.most = std::max(found.most, density);
      area += mesh.area(t);
      mass += density * mesh.area(t);
    }
  }
  found.mean = area > 0.0 ? mass / area : 0.0;
  return found;
}

// Where densities differ, a gradient between those of the lightest and the heaviest may be right.
std::string weight_warning(const Setup& setup, const mesh::Mesh& mesh, double stress) {
  const Densities density = densities_of(setup, mesh);
  const auto [low, high] =
      std::minmax_element(mesh.vertex.begin(), mesh.vertex.end(),
                          [](const Point& a, const Point& b) { return a.y < b.y; });
  const double height = high->y - low->y;
  const double gravity = setup.model.gravity;
  const double gradient = setup.in_situ->gradient_yy;
  constexpr double about = 0.2;  // what fluid in the pores adds to the density, among other things
  const bool is_carried = gradient >= (1.0 - about) * gravity * density.least &&
                          gradient <= (1.0 + about) * gravity * density.most;
  const double weight = gravity * density.mean;
  if (density.mean == 0.0 || is_carried ||
      std::abs(weight - gradient) * height <= much_of_weight * stress) {
    return {};
  }
  return fmt::format(
      "the in-situ stress does not carry the weight of the rock: over the {:.4g} m of its height "
      "gravity adds {} and in_situ.gradient_yy {}. The rock settles when the run starts. "
      "gradient_yy = {:.5g} (Pa/m) carries it{}{}",
      height, pressure_text(weight * height), pressure_text(gradient * height), weight,
      density.least < density.most ? " on average" : "",
      gravity != 0.0 ? "; model.gravity = 0 leaves weight out" : "");
}

}  // namespace

std::vector<std::string> start_balance_warnings(const Setup& setup, const mechanics::Model& model) {
  std::vector<std::string> warnings;
  const double stress = setup.in_situ ? largest_stress(*setup.in_situ, model.mesh) : 0.0;
  if (stress == 0.0) {
    return warnings;
  }
  const bool has_platen = std::any_of(setup.body.begin(), setup.body.end(),
                                      [](const auto& entry) { return entry.second.rigid; });
  if (!has_platen) {
    warnings.push_back(edge_warning(setup, model.mesh, stress));
  }
  warnings.push_back(weight_warning(setup, model.mesh, stress));
  std::erase(warnings, std::string());
  return warnings;
}

}  // namespace percolith::simulation
