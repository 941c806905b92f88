// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/solid_build.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "unit/support/grid.hpp"
#include "unit/support/places.hpp"
#include "unit/support/solid_setup.hpp"

namespace percolith::simulation {
namespace {

/// A grid whose left half is a rock of its own, clay.
mesh::GmshMesh half_clay() {
  mesh::GmshMesh file = test::make_grid({.columns = 8, .rows = 8});
  const auto clay = static_cast<std::int32_t>(file.regions.size());
  file.regions.push_back("clay");
  for (std::size_t t = 0; t < file.triangles.size(); ++t) {
    double x = 0.0;
    for (const auto p : file.triangles[t]) {
      x += file.points[static_cast<std::size_t>(p)].x / 3.0;
    }
    file.triangle_region[t] = x < 0.5 ? clay : file.triangle_region[t];
  }
  return file;
}

/// The same with a fracture across both rocks along y = 1/2.
mesh::Mesh two_rocks() {
  mesh::GmshMesh file = half_clay();
  auto& curve = file.curves["fault"];
  for (const auto& t : file.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = t[k];
      const auto b = t[(k + 1) % 3];
      const auto y = [&](auto p) { return file.points[static_cast<std::size_t>(p)].y; };
      if (a < b && y(a) == 0.5 && y(b) == 0.5) {
        curve.push_back({a, b});
      }
    }
  }
  return mesh::build_mesh(file);
}

TEST(SolidIngredients, AFractureTakesItsFrictionFromEachRockBesideIt) {
  simulation::Setup setup = test::solid_setup();
  Material clay = setup.material["sandstone"];
  clay.regions = {"clay"};
  clay.strength.friction_angle = 0.2;
  setup.material["clay"] = clay;
  setup.fracture["fault"].groups = {"fault"};
  const mesh::Mesh mesh = two_rocks();
  const mechanics::Ingredients from = solid_ingredients(setup, mesh);
  std::set<double> frictions;
  for (const mesh::Index j : mesh.curves.at("fault").joints) {
    const mechanics::JointKind& kind =
        from.kind[static_cast<std::size_t>(from.joint_kind[static_cast<std::size_t>(j)])];
    const auto& ends = mesh.joint[static_cast<std::size_t>(j)].vertex;
    const double x = 0.5 * (mesh.vertex[static_cast<std::size_t>(ends[0])].x +
                            mesh.vertex[static_cast<std::size_t>(ends[1])].x);
    EXPECT_EQ(kind.residual_friction, std::tan(x < 0.5 ? 0.2 : 0.6)) << x;
    // Tables are counted as the materials and then the fractures.
    EXPECT_EQ(kind.owner, 2);
    frictions.insert(kind.residual_friction);
  }
  EXPECT_EQ(frictions.size(), 2u);
}

TEST(SolidIngredients, AFractureBetweenTwoRocksHasTheSmallerFriction) {
  // The fracture runs along x = 1/2, between both rocks; the angles are given either way round.
  mesh::GmshMesh file = half_clay();
  for (std::int32_t j = 0; j < 8; ++j) {
    file.curves["fault"].push_back({9 * j + 4, 9 * (j + 1) + 4});
  }
  const mesh::Mesh mesh = mesh::build_mesh(file);
  for (const auto& [sandstone, clay] : {std::pair{0.6, 0.2}, std::pair{0.2, 0.6}}) {
    simulation::Setup setup = test::solid_setup();
    Material other = setup.material["sandstone"];
    other.regions = {"clay"};
    other.strength.friction_angle = clay;
    setup.material["clay"] = other;
    setup.material["sandstone"].strength.friction_angle = sandstone;
    setup.fracture["fault"].groups = {"fault"};
    const mechanics::Ingredients from = solid_ingredients(setup, mesh);
    for (const mesh::Index j : mesh.curves.at("fault").joints) {
      const auto kind = static_cast<std::size_t>(from.joint_kind[static_cast<std::size_t>(j)]);
      EXPECT_EQ(from.kind[kind].residual_friction, std::tan(0.2));
    }
  }
}

}  // namespace
}  // namespace percolith::simulation
