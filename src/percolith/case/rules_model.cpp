// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/rules.hpp"

#include <fmt/format.h>

namespace percolith::case_file {

namespace {

bool ends_with(const std::string& text, std::string_view end) {
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

void check_mesh(Rules& rules) {
  const std::string& file = rules.setup().mesh.file;
  if (!ends_with(file, ".msh") && !ends_with(file, ".geo")) {
    rules.fail("mesh.file", {}, "neither a mesh nor a geometry of Gmsh",
               "a file that ends in .msh or .geo");
  }
}

void check_permeability(Rules& rules, const std::string& key, const Tensor& k) {
  const bool scalar = k.xx == k.yy && k.xy == 0.0;
  if (!is_positive_definite(k)) {
    rules.fail(key, {"model.physics"},
               scalar ? "out of range" : "the tensor is not positive definite",
               scalar ? to_text(positive, "m2") : "kxx > 0, kyy > 0 and kxx kyy > kxy^2");
  }
}

void check_materials(Rules& rules) {
  if (rules.setup().material.empty()) {
    rules.fail("material", {}, "no rock is given", "one or more tables [material.NAME]");
  }
  GroupNames regions(rules);
  for (const auto& [name, material] : rules.setup().material) {
    const std::string path = "material." + name;
    regions.add(path + ".regions", material.regions);
    if (rules.has_flow()) {
      check_permeability(rules, path + ".permeability", material.rock.permeability);
    }
  }
}

void check_hydraulics(Rules& rules, const std::string& path, const material::Fracture& fracture) {
  if (fracture.minimum_aperture > fracture.maximum_aperture) {
    rules.fail(path + ".minimum_aperture", {path + ".maximum_aperture"},
               "greater than maximum_aperture",
               fmt::format("at most {} m", fracture.maximum_aperture));
  }
  const simulation::Stepping& time = rules.setup().time;
  const bool is_explicit = time.scheme == simulation::Scheme::explicit_ &&
                           time.pore_flow == simulation::PoreFlow::explicit_;
  if (rules.is_coupled() && fracture.minimum_aperture == 0.0) {
    rules.fail(path + ".minimum_aperture", {"model.physics"},
               "fluid in a crack that is pressed shut would have no room",
               "> 0 m where rock moves");
  }
  if (is_explicit && fracture.exchange == infinite) {
    rules.fail(path + ".exchange", {"time.scheme", "time.pore_flow"},
               rules.has_motion()
                   ? "explicit flow in the pores cannot give fracture and rock one pressure"
                   : "the explicit scheme cannot give fracture and rock one pressure",
               rules.has_motion() ? "a finite exchange, or time.pore_flow = \"implicit\""
                                  : "a finite exchange, or time.scheme = \"implicit\"");
  }
}

void check_fractures(Rules& rules) {
  GroupNames groups(rules);
  for (const auto& [name, group] : rules.setup().fracture) {
    const std::string path = "fracture." + name;
    groups.add(path + ".groups", group.groups);
    if (rules.has_flow()) {
      check_hydraulics(rules, path, group.fracture);
    }
  }
  if (rules.setup().new_cracks && rules.given("new_cracks.exchange")) {
    check_hydraulics(rules, "new_cracks", rules.setup().new_cracks->fracture);
  }
}

void check_boundary_groups(Rules& rules) {
  for (const auto& [name, condition] : rules.setup().boundary) {
    GroupNames groups(rules);
    groups.add("boundary." + name + ".groups", condition.groups);
  }
}

}  // namespace

void GroupNames::add(const std::string& key, const std::vector<std::string>& names) {
  if (names.empty() && rules_.given(key)) {
    rules_.fail(key, {}, "names no physical group of the mesh", "at least one name");
  }
  for (const std::string& name : names) {
    const auto [entry, is_new] = owner_.try_emplace(name, key);
    if (name.empty()) {
      rules_.fail(key, {}, "a name is empty", "names of physical groups of the mesh");
    } else if (!is_new) {
      rules_.fail(key, {},
                  entry->second == key
                      ? fmt::format("\"{}\" is named twice", name)
                      : fmt::format("\"{}\" already belongs to {}", name, entry->second),
                  "each name once");
    }
  }
}

void check_model(Rules& rules) {
  check_mesh(rules);
  check_materials(rules);
  check_fractures(rules);
  check_boundary_groups(rules);
}

}  // namespace percolith::case_file
