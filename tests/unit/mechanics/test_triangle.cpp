// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/energy.hpp"
#include "percolith/mechanics/strain.hpp"
#include "percolith/mechanics/triangle.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numbers>
#include <random>

#include "unit/support/solid_model.hpp"

namespace percolith::mechanics {
namespace {

using test::at;

const test::Grid grid{.columns = 3, .rows = 3, .jitter = 0.25, .seed = 4, .mixed_diagonals = true};

Point turned(Point p, double angle) {
  return {std::cos(angle) * p.x - std::sin(angle) * p.y,
          std::sin(angle) * p.x + std::cos(angle) * p.y};
}

/// Angle in degrees to radians, from whole numbers so that cases shrink well.
double radians(int degrees) {
  return degrees * std::numbers::pi / 180.0;
}

material::ElasticRock layered_rock() {
  material::ElasticRock rock = test::elastic_rock();
  rock.normal_young_modulus = 4e9;
  rock.bedding_angle = 0.4;
  return rock;
}

/// A smooth, large deformation of the unit square.
Point bent(Point p) {
  return {0.1 * p.x + 0.07 * p.y * p.y, -0.05 * p.y + 0.12 * p.x * p.y};
}

double size(Point p) {
  return std::sqrt(dot(p, p));
}

TEST(Triangle, RigidRotationByAnyAngleGivesNoForce) {
  rc::check("forces of a rotated and shifted triangle vanish to round-off", [] {
    const double angle = radians(*rc::gen::inRange(-720, 721));
    const Point shift{static_cast<double>(*rc::gen::inRange(-5, 6)),
                      static_cast<double>(*rc::gen::inRange(-5, 6))};
    Model model = test::make_solid(test::make_grid(grid));
    test::displace(model, [&](Point p) { return turned(p, angle) + shift - p; });
    for (Index t = 0; t < model.mesh.triangles(); ++t) {
      for (const Point& f : test::stress_forces(model, t)) {
        // E times an edge is the force of a strain of one.
        RC_ASSERT(size(f) < 1e-13 * 10e9);
      }
    }
  });
}

TEST(Triangle, StressTurnsWithTheTriangle) {
  rc::check("forces and stress of a rotated deformation are those of the deformation, rotated", [] {
    const double angle = radians(*rc::gen::inRange(-360, 361));
    Model model = test::make_solid(test::make_grid(grid), {.rock = layered_rock()});
    Model other = model;
    test::displace(model, bent);
    test::displace(other, [&](Point p) { return turned(p + bent(p), angle) - p; });
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    for (Index t = 0; t < model.mesh.triangles(); ++t) {
      const auto f = test::stress_forces(model, t);
      const auto g = test::stress_forces(other, t);
      for (std::size_t k = 0; k < 3; ++k) {
        RC_ASSERT(size(g[k] - turned(f[k], angle)) < 1e-12 * 10e9);
      }
      const Tensor a = triangle_stress(model, t).plane;
      const Tensor b = triangle_stress(other, t).plane;
      RC_ASSERT(std::abs(c * c * a.xx + s * s * a.yy - 2 * c * s * a.xy - b.xx) < 1e-12 * 10e9);
      RC_ASSERT(std::abs(c * s * (a.xx - a.yy) + (c * c - s * s) * a.xy - b.xy) < 1e-12 * 10e9);
      RC_ASSERT(std::abs(triangle_stress(model, t).across - triangle_stress(other, t).across) <
                1e-12 * 10e9);
    }
  });
}

TEST(Triangle, ForcesBalanceAndHaveNoMoment) {
  Model model = test::make_solid(test::make_grid(grid), {.rock = layered_rock()});
  test::displace(model, bent);
  set_initial_stress(model, [](Point p) { return Tensor{1e8 * p.x, -2e8, 1e8 * p.y}; });
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    const auto f = test::stress_forces(model, t);
    const auto p = model.mesh.triangle_points(t);
    Point sum{};
    double moment = 0.0;
    double largest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      sum = sum + f[k];
      moment += cross(p[k] + bent(p[k]), f[k]);
      largest = std::max(largest, size(f[k]));
    }
    EXPECT_GT(largest, 1e6);
    EXPECT_LT(size(sum), 1e-13 * largest);
    EXPECT_LT(std::abs(moment), 1e-13 * largest);
  }
}

TEST(Triangle, SmallStrainsAreThoseOfLinearElasticity) {
  const Point dx{3e-9, -2e-9};  // gradient of the displacement by x and by y
  const Point dy{5e-9, 4e-9};
  Model model = test::make_solid(test::make_grid(grid), {.rock = layered_rock()});
  test::displace(model, [&](Point p) { return p.x * dx + p.y * dy; });
  const auto d = material::plane_stiffness(layered_rock(), material::Plane::strain);
  const Tensor strain{dx.x, dy.y, 0.5 * (dx.y + dy.x)};
  const Tensor stress = material::stress_of(d, strain);
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    const Tensor s = triangle_stress(model, t).plane;
    EXPECT_NEAR(s.xx, stress.xx, 1e-7 * std::abs(stress.xx));
    EXPECT_NEAR(s.yy, stress.yy, 1e-7 * std::abs(stress.yy));
    EXPECT_NEAR(s.xy, stress.xy, 1e-7 * std::abs(stress.xx));
    // (9): half of the traction on the edge opposite each corner.
    const auto p = model.mesh.triangle_points(t);
    const auto f = test::stress_forces(model, t);
    for (std::size_t k = 0; k < 3; ++k) {
      const Point pull = 0.5 * (stress * clockwise(p[(k + 2) % 3] - p[(k + 1) % 3]));
      EXPECT_LT(size(f[k] - pull), 1e-6 * std::abs(stress.xx));
    }
  }
}

TEST(Triangle, ForcesAreMinusTheSlopeOfTheElasticEnergy) {
  Model model = test::make_solid(test::make_grid(grid), {.rock = layered_rock()});
  test::displace(model, bent);
  set_initial_stress(model, [](Point p) { return Tensor{1e8, -2e8 * p.y, 3e7}; });
  Execution serial(Backend::serial);
  constexpr double step = 1e-5;
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    const auto f = test::stress_forces(model, t);
    for (Index k = 0; k < 3; ++k) {
      const auto c = at(mesh::corner_of(t, k));
      for (auto* u : {&model.motion.ux, &model.motion.uy}) {
        const double start = (*u)[c];
        (*u)[c] = start + step;
        const double after = elastic_energy(model, displacements_before(model, 0.0), serial);
        (*u)[c] = start - step;
        const double before = elastic_energy(model, displacements_before(model, 0.0), serial);
        (*u)[c] = start;
        const double force = u == &model.motion.ux ? f[at(k)].x : f[at(k)].y;
        EXPECT_NEAR(-(after - before) / (2 * step), force, 1e-6 * 1e9);
      }
    }
  }
}

TEST(Triangle, StretchGivesTheStressOfASaintVenantKirchhoffSolid) {
  // Stretch l along x alone: E = (l^2 - 1)/2, S_xx = (lambda + 2 G) E, sigma_xx = l S_xx.
  Model model = test::make_solid(test::make_grid(grid));
  test::displace(model, [](Point p) { return Point{0.2 * p.x, 0.0}; });
  const double green = 0.5 * (1.2 * 1.2 - 1.0);
  const TriangleStress s = triangle_stress(model, 5);
  EXPECT_NEAR(s.plane.xx, 1.2 * 12e9 * green, 1.0);
  EXPECT_NEAR(s.plane.yy, 4e9 * green / 1.2, 1.0);
  EXPECT_NEAR(s.across, 4e9 * green, 1.0);
  EXPECT_NEAR(triangle_strain(model, 5).strain.xx, green, 1e-14);
}

TEST(Triangle, PlaneStressLeavesNoStressAcross) {
  Model model = test::make_solid(test::make_grid(grid), {.plane = material::Plane::stress});
  test::displace(model, [](Point p) { return Point{1e-6 * p.x, 0.0}; });
  const TriangleStress s = triangle_stress(model, 0);
  EXPECT_NEAR(s.plane.xx, 1e-6 * 10e9 / (1 - 0.0625), 0.1);
  EXPECT_NEAR(s.plane.yy, 0.25e-6 * 10e9 / (1 - 0.0625), 0.1);
  EXPECT_EQ(s.across, 0.0);
}

TEST(Triangle, ViscousForcesFollowTheRateOfStrain) {
  // D_xx = 3/s: stress 2 mu D pulls corners together, and spends 2 mu D:D times the area.
  Model model = test::make_solid(test::make_grid(grid), {.viscosity = 50.0});
  test::set_velocity(model, [](Point p) { return Point{3.0 * p.x, 0.0}; });
  double spent = 0.0;
  test::for_each_corner(model.mesh, [&](Index t, Index c) {
    const Point f = test::stress_forces(model, t)[at(mesh::local_of(c))];
    spent -= f.x * model.motion.vx[at(c)] + f.y * model.motion.vy[at(c)];
  });
  EXPECT_NEAR(spent, 2 * 50.0 * 9.0, 1e-9);
}

TEST(Triangle, ViscosityDoesNotResistRotation) {
  Model model = test::make_solid(test::make_grid(grid), {.viscosity = 50.0});
  const double angle = 1.1;
  test::displace(model, [&](Point p) { return turned(p, angle) - p; });
  test::set_velocity(model, [&](Point p) {
    const Point now = turned(p, angle);
    return 7.0 * Point{-now.y, now.x};
  });
  const Model still = [&] {
    Model copy = model;
    test::set_velocity(copy, [](Point) { return Point{}; });
    return copy;
  }();
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    const auto moving = test::stress_forces(model, t);
    const auto resting = test::stress_forces(still, t);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_LT(size(moving[k] - resting[k]), 1e-3 * 1e-9 * 10e9);
    }
  }
}

TEST(Principal, ValuesAndDirection) {
  const Principal p = principal({3.0, 1.0, 1.0});
  EXPECT_NEAR(p.first, 2 + std::sqrt(2.0), 1e-14);
  EXPECT_NEAR(p.second, 2 - std::sqrt(2.0), 1e-14);
  const Point image = Tensor{3.0, 1.0, 1.0} * p.direction;
  EXPECT_NEAR(image.x, p.first * p.direction.x, 1e-14);
  EXPECT_NEAR(image.y, p.first * p.direction.y, 1e-14);
  EXPECT_NEAR(principal({-5.0, 2.0, 0.0}).direction.y, 1.0, 1e-15);
}

}  // namespace
}  // namespace percolith::mechanics
