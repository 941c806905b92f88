// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/cli/check_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace percolith::cli {
namespace {

std::string mesh_text(const simulation::CheckReport& report) {
  std::string text = fmt::format(
      "Mesh\n"
      "  triangles       {:>10}    vertices        {:>10}\n"
      "  joints          {:>10}    broken joints   {:>10}\n"
      "  boundary edges  {:>10}\n"
      "  extent          x {:.5g} to {:.5g} m, y {:.5g} to {:.5g} m\n"
      "  area            {:>10.5g} m2\n"
      "  edges           {:.4g} to {:.4g} m\n"
      "  angles          {:.1f} to {:.1f} degree, smallest at ({:.5g}, {:.5g}) m\n",
      report.triangles, report.vertices, report.joints, report.broken_joints, report.boundary_edges,
      report.lower_corner.x, report.upper_corner.x, report.lower_corner.y, report.upper_corner.y,
      report.area, report.smallest_edge, report.largest_edge, report.smallest_angle,
      report.largest_angle, report.smallest_angle_place.x, report.smallest_angle_place.y);
  for (const auto& [region, area] : report.region_area) {
    text += fmt::format("  region {}: {:.5g} m2\n", region, area);
  }
  for (const auto& [fracture, length] : report.fracture_length_by_group) {
    text += fmt::format("  fracture {}: {:.5g} m\n", fracture, length);
  }
  return text;
}

std::string node_text(const simulation::CheckReport& report) {
  return fmt::format("Flow\n"
                     "  pore nodes      {:>10}    crack nodes     {:>10}\n"
                     "  unknowns        {:>10}\n",
                     report.pore_nodes, report.crack_nodes, report.unknowns);
}

// Counts in full, however large.
std::string number_text(const std::variant<double, std::int64_t>& value) {
  const double* real = std::get_if<double>(&value);
  return real != nullptr ? fmt::format("{:.5g}", *real)
                         : fmt::format("{}", std::get<std::int64_t>(value));
}

std::string mechanics_text(const simulation::CheckReport& report) {
  std::size_t width = 0;
  for (const auto& [name, value] : report.mechanics) {
    width = std::max(width, name.size());
  }
  std::string text = "Mechanics\n";
  for (const auto& [name, value] : report.mechanics) {
    text += fmt::format("  {:<{}}  {:>10}\n", name, width, number_text(value));
  }
  return text;
}

// `more` stands between the scheme and its step.
std::string explicit_text(const simulation::Stepping& stepping, double stable,
                          const std::string& more) {
  const double step = stepping.safety * stable;
  const double used = std::fmin(step, stepping.step.value_or(step));
  return fmt::format("  scheme explicit{}: step {:.4g} s, about {:.3g} steps to the end\n", more,
                     used, std::ceil(stepping.end / used));
}

std::string limit_text(const simulation::CheckReport& report,
                       const simulation::Stepping& stepping) {
  const bool is_mechanics = !report.mechanics.empty();
  if (!is_mechanics && stepping.scheme == simulation::Scheme::steady) {
    return "  scheme steady: takes no time step\n";
  }
  std::string text = "Limits of the explicit time step\n";
  bool first = true;
  for (const simulation::StepLimit& limit : report.limits) {
    text += fmt::format("  {:<15} {:>10.4g} s at ({:.5g}, {:.5g}) m{}\n", limit.mechanism,
                        limit.step, limit.place.x, limit.place.y, first ? "  <- rules" : "");
    first = false;
  }
  if (first) {
    return text + (is_mechanics ? "  none: nothing moves\n" : "  none: nothing flows\n");
  }
  double stable = std::numeric_limits<double>::infinity();
  for (const simulation::StepLimit& limit : report.limits) {
    stable = std::fmin(stable, limit.step);  // the mechanisms act together: the last one holds
  }
  if (stepping.scheme == simulation::Scheme::quasi_static) {
    return text + "  scheme quasi_static: no step of time is bound by these\n";
  }
  if (is_mechanics) {  // which has no other scheme
    return text + explicit_text(stepping, stable, fmt::format(", safety {:g}", stepping.safety));
  }
  if (stepping.scheme == simulation::Scheme::explicit_) {
    return text + explicit_text(stepping, stable, "");
  }
  return text + "  scheme implicit: the step is ruled by time.tolerance, not by these\n";
}

}  // namespace

std::string check_text(const simulation::CheckReport& report,
                       const simulation::Stepping& stepping) {
  return mesh_text(report) + (report.pore_nodes > 0 ? node_text(report) : "") +
         (report.mechanics.empty() ? "" : mechanics_text(report)) + limit_text(report, stepping);
}

}  // namespace percolith::cli
