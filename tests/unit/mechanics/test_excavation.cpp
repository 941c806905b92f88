// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/excavation.hpp"
#include "percolith/mechanics/strain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "unit/support/solid_model.hpp"

namespace percolith::mechanics {
namespace {

using test::at;

const test::Grid grid{.columns = 6, .rows = 6, .jitter = 0.1, .seed = 6};
const Tensor in_situ{-8e6, -5e6, 1e6};

bool is_dug(Point p) {
  return p.x > 1.0 / 3 && p.x < 2.0 / 3 && p.y > 1.0 / 3 && p.y < 2.0 / 3;
}

std::vector<Index> dug_triangles(const mesh::Mesh& mesh) {
  std::vector<Index> triangles;
  for (Index t = 0; t < mesh.triangles(); ++t) {
    if (is_dug(test::centroid(mesh, t))) {
      triangles.push_back(t);
    }
  }
  return triangles;
}

/// Rock under in-situ stress that is held at the rim; straight lines bound what is dug.
Dynamics stressed(JointState joints, double gravity = 0.0) {
  test::Grid straight = grid;
  straight.jitter = 0.0;
  Model model =
      test::make_solid(test::make_grid(straight),
                       {.joints = joints, .gravity = gravity, .damping = {.nodal_viscosity = 3e5}});
  set_initial_stress(model, [](Point) { return in_situ; });
  std::vector<Held> held;
  for (const Point direction : {Point{1.0, 0.0}, Point{0.0, 1.0}}) {
    test::hold_where(
        model, [](Point p) { return p.x == 0.0 || p.x == 1.0 || p.y == 0.0 || p.y == 1.0; },
        direction, 0, held);
  }
  SupportSet supports(model, {{"rim", PrescribedMotion::Kind::velocity, Schedule{}}}, held);
  return test::make_dynamics(std::move(model), {}, std::move(supports));
}

TEST(Excavation, NothingMovesUntilTheSupportFades) {
  for (const JointState joints : {JointState::tied, JointState::bonded}) {
    for (const int steps_before : {0, 5}) {
      Dynamics dynamics = stressed(joints);
      const double dt = 0.8 * test::stable_step(dynamics);
      test::advance(dynamics, dt, steps_before);
      const std::vector<Index> triangles = dug_triangles(dynamics.model().mesh);
      ASSERT_EQ(triangles.size(), 8u);
      dynamics.take_out(triangles, 1e6);  // for ever, so to speak
      test::advance(dynamics, dt, 200);
      test::for_each_corner(dynamics.model().mesh, [&](Index, Index c) {
        EXPECT_LT(test::distance(test::displacement(dynamics.model(), c), {}), 1e-11);
      });
      EXPECT_LT(dynamics.unbalanced_ratio(), 1e-5);
    }
  }
}

TEST(Excavation, EndsWhereRockWithAHoleUnderTheSameStressDoes) {
  for (const JointState joints : {JointState::tied, JointState::bonded}) {
    Dynamics dynamics = stressed(joints);
    const double dt = 0.8 * test::stable_step(dynamics);
    test::advance(dynamics, dt, 1);
    dynamics.take_out(dug_triangles(dynamics.model().mesh), 500 * dt);
    test::advance(dynamics, dt, 20000);

    // The same rock without the part from the start.
    test::Grid straight = grid;
    straight.jitter = 0.0;
    mesh::GmshMesh file = test::make_grid(straight);
    std::erase_if(file.triangles, [&](const auto& t) {
      const auto p = [&](std::size_t k) { return file.points[static_cast<std::size_t>(t[k])]; };
      return is_dug((1.0 / 3) * (p(0) + p(1) + p(2)));
    });
    file.triangle_region.resize(file.triangles.size());
    std::vector<std::int32_t> number(file.points.size(), -1);
    std::vector<Point> used;
    for (auto& t : file.triangles) {
      for (auto& p : t) {
        auto& n = number[static_cast<std::size_t>(p)];
        if (n < 0) {
          n = static_cast<std::int32_t>(used.size());
          used.push_back(file.points[static_cast<std::size_t>(p)]);
        }
        p = n;
      }
    }
    file.points = used;
    file.curves.clear();
    Model model = test::make_solid(file, {.joints = joints, .damping = {.nodal_viscosity = 3e5}});
    set_initial_stress(model, [](Point) { return in_situ; });
    std::vector<Held> held;
    for (const Point direction : {Point{1.0, 0.0}, Point{0.0, 1.0}}) {
      test::hold_where(
          model, [](Point p) { return p.x == 0.0 || p.x == 1.0 || p.y == 0.0 || p.y == 1.0; },
          direction, 0, held);
    }
    SupportSet supports(model, {{"rim", PrescribedMotion::Kind::velocity, Schedule{}}}, held);
    Dynamics hole = test::make_dynamics(std::move(model), {}, std::move(supports));
    test::advance(hole, dt, 20000);

    double largest = 0.0;
    for (int i = 0; i <= 6; ++i) {
      for (int j = 0; j <= 6; ++j) {
        const Point p{i / 6.0, j / 6.0};
        if (i == 3 && j == 3) {
          continue;
        }
        // The mean of the corners that are still there.
        Point left{};
        int count = 0;
        for (const Index c :
             dynamics.model().mesh.vertex_corners.row(test::vertex_at(dynamics.model().mesh, p))) {
          if (dynamics.model().triangles.inverse_mass[at(mesh::triangle_of(c))] > 0.0) {
            left = left + test::displacement(dynamics.model(), c);
            ++count;
          }
        }
        left = (1.0 / count) * left;
        const Point expected = test::displacement_at(hole.model(), p);
        largest = std::max(largest, test::distance(expected, {}));
        EXPECT_LT(test::distance(left, expected), 1e-8) << p.x << ' ' << p.y;
      }
    }
    EXPECT_GT(largest, 1e-5);
  }
}

TEST(Excavation, EnergyOfWhatIsTakenOutIsBooked) {
  for (const JointState joints : {JointState::tied, JointState::bonded}) {
    Dynamics dynamics = stressed(joints, 9.81);
    const double dt = 0.3 * test::stable_step(dynamics);
    test::advance(dynamics, dt, 500);
    const EnergyBalance before = dynamics.energy(Execution());
    dynamics.take_out(dug_triangles(dynamics.model().mesh), 300 * dt);
    const EnergyBalance at_once = dynamics.energy(Execution());
    EXPECT_NEAR(at_once.elastic + at_once.joint + at_once.absorbed,
                before.elastic + before.joint + before.absorbed, 1e-2 * (before.gravity + 1e-6));
    test::advance(dynamics, dt, 3000);
    const EnergyBalance e = dynamics.energy(Execution());
    const double scale = std::max({std::abs(e.external), e.damping, std::abs(e.elastic)});
    EXPECT_GT(scale, 10.0);
    EXPECT_LT(std::abs(e.residual), 5e-3 * scale);
    EXPECT_LT(std::abs(e.fracture), 5e-3 * scale);
  }
}

TEST(Excavation, WhatIsTakenOutIsGone) {
  Dynamics dynamics = stressed(JointState::bonded, 9.81);
  const std::vector<Index> triangles = dug_triangles(dynamics.model().mesh);
  dynamics.take_out(triangles, 1e-6);
  const Model& model = dynamics.model();
  for (const Index t : triangles) {
    EXPECT_EQ(model.triangles.inverse_mass[at(t)], 0.0);
    EXPECT_EQ(model.triangles.weight[at(t)], 0.0);
    for (Index k = 0; k < 3; ++k) {
      EXPECT_EQ(model.fans.leader(mesh::corner_of(t, k)), mesh::corner_of(t, k));
    }
  }
  test::advance(dynamics, 0.8 * test::stable_step(dynamics), 100);
  for (const Index t : triangles) {
    for (Index k = 0; k < 3; ++k) {
      EXPECT_EQ(test::displacement(model, mesh::corner_of(t, k)).y, 0.0);
    }
  }
  const Fragments fragments = find_fragments(model);
  ASSERT_EQ(fragments.area.size(), 1u);
  EXPECT_NEAR(fragments.area[0], 1.0 - 4.0 / 36.0, 1e-12);
}

}  // namespace
}  // namespace percolith::mechanics
