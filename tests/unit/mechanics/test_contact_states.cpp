// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "unit/mechanics/test_contact_support.hpp"

namespace percolith::mechanics {
namespace {

using test::at;

/// Two squares' worth of triangles on a grid that is broken along every joint.
test::Bodies broken_pair(const test::Material& material = {}) {
  return test::Bodies(percolith::test::make_grid({.columns = 1, .rows = 1}), material);
}

/// Moves the upper left triangle of the square across the diagonal, by `depth`, into the other.
void press(test::Bodies& bodies, double depth) {
  const double by = depth / std::sqrt(2.0);
  bodies.move(1, {by, -by});
}

double raw_force(double depth) {
  test::Bodies bodies = broken_pair();
  bodies.advance();
  press(bodies, depth);
  bodies.advance(depth);
  return std::hypot(bodies.force(1).x, bodies.force(1).y);
}

double size_of(const Point& p) {
  return std::hypot(p.x, p.y);
}

TEST(ContactStates, TwoTrianglesCollideElastically) {
  test::Bodies bodies = test::Bodies::of(
      {test::pointed, {Point{-0.4, 0.9}, Point{0.3, 0.85}, Point{0.1, 1.6}}}, {1e9, 0.0, 0.0});
  const double mass = 1000.0;
  const double inertia = 100.0;
  const double dt = 1e-6;
  struct Rigid {
    Point v;
    double spin = 0.0;
  };
  std::array<Rigid, 2> body{Rigid{{0.0, 0.0}, 0.0}, Rigid{{0.1, -5.0}, 0.0}};
  const auto kinetic = [&] {
    double sum = 0.0;
    for (const Rigid& b : body) {
      sum += 0.5 * mass * dot(b.v, b.v) + 0.5 * inertia * b.spin * b.spin;
    }
    return sum;
  };
  const double before = kinetic();
  double least = before;
  int touched = 0;
  for (int step = 0; step < 60000; ++step) {
    bodies.advance(1e-5, dt);
    touched += bodies.contact().touching_pairs();
    for (Index t = 0; t < 2; ++t) {
      const Point middle =
          (1.0 / 3.0) * (bodies.corner(t, 0) + bodies.corner(t, 1) + bodies.corner(t, 2));
      double torque = 0.0;
      for (Index k = 0; k < 3; ++k) {
        torque += cross(bodies.corner(t, k) - middle, bodies.corner_force(t, k));
      }
      Rigid& b = body[at(t)];
      b.v = b.v + (dt / mass) * bodies.force(t);
      b.spin += dt / inertia * torque;
      const double angle = b.spin * dt;
      for (Index k = 0; k < 3; ++k) {
        const Point arm = bodies.corner(t, k) - middle;
        const Point turn{(std::cos(angle) - 1.0) * arm.x - std::sin(angle) * arm.y,
                         std::sin(angle) * arm.x + (std::cos(angle) - 1.0) * arm.y};
        bodies.ux()[bodies.slot(t, k)] += dt * b.v.x + turn.x;
        bodies.uy()[bodies.slot(t, k)] += dt * b.v.y + turn.y;
      }
    }
    least = std::min(least, kinetic());
    if (least < before) {
      EXPECT_NEAR(kinetic() + bodies.potential_energy(), before, 1e-2 * before);
    }
    if (touched > 0 && bodies.contact().touching_pairs() == 0) {
      break;
    }
  }
  EXPECT_GT(touched, 100);
  EXPECT_LT(least, 0.9 * before);
  EXPECT_EQ(bodies.contact().touching_pairs(), 0);
  EXPECT_NEAR(kinetic(), before, 1e-3 * before);
}

TEST(ContactStates, SlowlyInAndOutTakesNoWork) {
  test::Bodies bodies = test::Bodies::of({test::floor_triangle, test::pointed}, {1e9, 0.0, 0.0});
  double work = 0.0;
  double most = 0.0;
  const int steps = 2000;
  const double pi = std::acos(-1.0);
  bodies.advance();
  for (int i = 0; i < steps; ++i) {
    // Along a loop that goes in at one place and out at another.
    const double a = 2.0 * pi * i / steps;
    const double b = 2.0 * pi * (i + 1) / steps;
    const Point by{0.3 * (std::cos(b) - std::cos(a)), -0.1 * (std::sin(b) - std::sin(a))};
    const Point before = bodies.force(1);
    bodies.move(1, by);
    bodies.advance(size_of(by));
    work += 0.5 * dot(before + bodies.force(1), by);
    most = std::max(most, std::abs(work));
  }
  EXPECT_GT(most, 1e4);
  EXPECT_NEAR(work, 0.0, 1e-5 * most);
}

TEST(ContactStates, ASearchChangesNoForce) {
  for (const double travelled : {0.0, 10.0}) {
    test::Bodies bodies = broken_pair();
    bodies.advance();
    press(bodies, 1e-3);
    bodies.advance(1e-3, 1.0);
    bodies.set_velocity(1, {1e-6, 1e-6});
    bodies.advance(1e-3, 1.0);
    bodies.set_velocity(1, {});
    const Point before = bodies.force(1);
    const double stored = bodies.contact().stored_tangential();
    ASSERT_GT(stored, 0.0);
    bodies.refresh();
    bodies.advance(travelled, 1.0);
    EXPECT_DOUBLE_EQ(bodies.force(1).x, before.x);
    EXPECT_DOUBLE_EQ(bodies.force(1).y, before.y);
    EXPECT_DOUBLE_EQ(bodies.contact().stored_tangential(), stored);
  }
}

TEST(ContactStates, AnOverlapThatIsThereAtFirstIsTakenOffAndWorkedOff) {
  test::Bodies bodies = broken_pair();
  press(bodies, 1e-3);
  bodies.advance();
  EXPECT_NEAR(size_of(bodies.force(1)), 0.0, 1e-12 * raw_force(1e-3));
  EXPECT_EQ(bodies.potential_energy(), 0.0);
  const auto expect = [&](double depth, double force) {
    bodies.advance(1e-3);
    EXPECT_NEAR(size_of(bodies.force(1)), force, 1e-9 * raw_force(depth)) << depth;
  };
  press(bodies, 1e-3);
  expect(2e-3, raw_force(2e-3) - raw_force(1e-3));
  press(bodies, -1.5e-3);
  expect(0.5e-3, 0.0);
  press(bodies, 1e-3);
  expect(1.5e-3, raw_force(1.5e-3) - raw_force(0.5e-3));
  // Apart and back: nothing is left of it.
  press(bodies, -2.5e-3);
  expect(1e-3, 0.0);
  press(bodies, 2e-3);
  expect(1e-3, raw_force(1e-3));
}

struct HandedOver {
  test::Bodies bodies = broken_pair();
  Point normal, along;  // on triangle 1, the upper left one
  Index side = 0;       // of triangle 1

  HandedOver(double depth, double normal_force, double shear, double stiffness = 0.0) {
    press(bodies, depth);
    const double half = 1.0 / std::sqrt(2.0);
    normal = {-half, half};
    along = {half, half};
    side = bodies.triangle(1) < bodies.triangle(0) ? 0 : 1;
    const double sign = side == 0 ? 1.0 : -1.0;
    bodies.contact().hand_over(bodies.mesh(), {0, normal_force, (sign * shear) * along, stiffness});
    bodies.advance();
  }
};

TEST(ContactStates, FacesCarryOnTheForceOfTheirJoint) {
  const double raw = raw_force(1e-3);
  for (const double share : {0.3, 1.0, 4.0, 0.02, -0.5}) {
    const double expected = std::max(share, 0.0) * raw;
    HandedOver pair(1e-3, share * raw, 0.1 * expected, share * raw / (1e-3 * std::sqrt(2.0)));
    const Point force = pair.bodies.force(1);
    EXPECT_NEAR(dot(force, pair.normal), expected, 1e-9 * raw) << share;
    EXPECT_NEAR(dot(force, pair.along), 0.1 * expected, 1e-9 * raw) << share;
    EXPECT_NEAR(size_of(pair.bodies.force(0) + force), 0.0, 1e-14 * raw);
  }
}

TEST(ContactStates, FacesDoNotBecomeMuchStifferThanJointAndContact) {
  const double raw = raw_force(1e-3);
  HandedOver pair(1e-3, 4.0 * raw, 0.0);
  EXPECT_NEAR(dot(pair.bodies.force(1), pair.normal), 1.25 * raw, 0.01 * raw);
}

TEST(ContactStates, WhatIsTakenOutLeavesItsForces) {
  test::Bodies bodies = broken_pair();
  bodies.advance();
  press(bodies, 1e-3);
  bodies.advance(1e-3, 1e-4);
  const Point force = bodies.force(1);
  ASSERT_GT(size_of(force), 0.0);
  const double stored = bodies.potential_energy() + bodies.contact().stored_tangential();
  std::vector<std::uint8_t> removed(2, 0);
  removed[at(bodies.triangle(0))] = 1;
  const ContactRelease left = bodies.contact().release(bodies.mesh(), bodies.motion(), removed);
  EXPECT_NEAR(left.energy, stored, 1e-14 * stored);
  ASSERT_EQ(left.force.size(), 3u);
  Point sum{};
  for (const CornerForce& f : left.force) {
    EXPECT_EQ(mesh::triangle_of(f.corner), bodies.triangle(1));
    sum = sum + f.force;
  }
  EXPECT_NEAR(size_of(sum - force), 0.0, 1e-14 * size_of(force));
  EXPECT_EQ(bodies.potential_energy(), 0.0);
}

TEST(ContactStates, TheShearOfAJointIsHeldToCoulombsLimit) {
  const double raw = raw_force(1e-3);
  HandedOver pair(1e-3, raw, -2.0 * raw);
  EXPECT_NEAR(dot(pair.bodies.force(1), pair.along), -0.5 * raw, 1e-9 * raw);
}

TEST(ContactStates, TheFactorStaysUntilTheFacesPart) {
  const double raw = raw_force(1e-3);
  HandedOver pair(1e-3, 0.25 * raw, 0.0);
  press(pair.bodies, 1e-3);
  pair.bodies.advance(1e-3);
  EXPECT_NEAR(size_of(pair.bodies.force(1)), 0.25 * raw_force(2e-3), 1e-9 * raw);
  press(pair.bodies, -3e-3);
  pair.bodies.advance(3e-3);
  EXPECT_EQ(pair.bodies.force(1), (Point{0.0, 0.0}));
  press(pair.bodies, 2e-3);
  pair.bodies.advance(2e-3);
  EXPECT_NEAR(size_of(pair.bodies.force(1)), raw, 1e-9 * raw);
}

TEST(ContactStates, FacesGivenUpUnderTensionStillResistLater) {
  const double raw = raw_force(1e-3);
  HandedOver pair(1e-3, -raw, 0.0);
  EXPECT_NEAR(size_of(pair.bodies.force(1)), 0.0, 1e-9 * raw);
  press(pair.bodies, 1e-3);
  pair.bodies.advance(1e-3);
  EXPECT_NEAR(size_of(pair.bodies.force(1)), 0.1 * (raw_force(2e-3) - raw), 1e-9 * raw);
}

TEST(ContactStates, ForcesOfTrianglesTakenOutVanish) {
  test::Bodies bodies = broken_pair();
  bodies.advance();
  press(bodies, 1e-3);
  bodies.advance(1e-3);
  EXPECT_EQ(bodies.contact().acts()[0], 1);
  EXPECT_GT(bodies.contact().deepest(), 0.99e-3);
  bodies.candidate().assign(2, 0);
  bodies.refresh();
  bodies.advance();
  EXPECT_EQ(bodies.contact().acts()[0], 0);
  EXPECT_EQ(bodies.force(0), (Point{0.0, 0.0}));
  EXPECT_EQ(bodies.force(1), (Point{0.0, 0.0}));
  EXPECT_EQ(bodies.contact().deepest(), 0.0);
}

TEST(ContactStates, InvertedTrianglesGiveNoForce) {
  test::Bodies bodies = broken_pair();
  bodies.advance();
  press(bodies, 1e-3);
  bodies.advance(1e-3);
  ASSERT_EQ(bodies.contact().touching_pairs(), 1);
  // Its last corner pushed through the opposite edge, and then exactly onto it.
  const Point corner = bodies.corner(0, 2);
  const Point middle = 0.5 * (bodies.corner(0, 0) + bodies.corner(0, 1));
  for (const double share : {1.5, 1.0}) {
    bodies.ux()[bodies.slot(0, 2)] += share * (middle.x - corner.x);
    bodies.uy()[bodies.slot(0, 2)] += share * (middle.y - corner.y);
    bodies.advance(10.0);
    EXPECT_EQ(bodies.contact().touching_pairs(), 0);
    EXPECT_EQ(bodies.force(1), (Point{0.0, 0.0}));
    bodies.ux()[bodies.slot(0, 2)] -= share * (middle.x - corner.x);
    bodies.uy()[bodies.slot(0, 2)] -= share * (middle.y - corner.y);
  }
}

TEST(ContactStates, BodiesThatOverlapAtTheStartAreNamed) {
  test::Bodies bodies = test::Bodies::of({test::floor_triangle, test::pointed, test::flat});
  std::array<Index, 2> expected{bodies.triangle(1), bodies.triangle(2)};
  std::sort(expected.begin(), expected.end());
  const auto found = bodies.contact().overlapping(bodies.mesh(), bodies.motion());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0], expected);
}

/// A block broken along every joint whose triangles are pushed into each other at random.
test::Bodies rubble() {
  test::Bodies bodies(percolith::test::make_grid({.columns = 40, .rows = 40, .jitter = 0.2}));
  std::mt19937 random(2);
  std::uniform_real_distribution<double> shift(-2e-4, 2e-4);
  bodies.advance();
  for (Index t = 0; t < bodies.mesh().triangles(); ++t) {
    bodies.move(t, {shift(random), shift(random)});
    bodies.set_velocity(t, {shift(random), shift(random)});
  }
  return bodies;
}

std::string hash_after_steps(Backend backend, int threads) {
  test::Bodies bodies = rubble();
  Execution execution(backend, threads);
  for (int step = 0; step < 5; ++step) {
    for (Index t = 0; t < bodies.mesh().triangles(); ++t) {
      bodies.move(t, {1e-6 * (t % 7), 1e-6 * (t % 5)});
    }
    bodies.advance(1e-3, 1e-3, execution);
  }
  EXPECT_GT(bodies.contact().touching_pairs(), 1000);
  EXPECT_GT(bodies.contact().listed_pairs(), 4096);
  EXPECT_GT(bodies.contact().friction_dissipation(), 0.0);
  StateHash hash;
  bodies.contact().add_to(hash);
  return hash.text();
}

TEST(ContactStates, SameBitsForEveryBackendAndNumberOfThreads) {
  const std::string serial = hash_after_steps(Backend::serial, 1);
  EXPECT_EQ(hash_after_steps(Backend::host, 1), serial);
  EXPECT_EQ(hash_after_steps(Backend::host, 2), serial);
}

TEST(ContactStates, RubbleKeepsItsMomentum) {
  test::Bodies bodies = rubble();
  bodies.advance(1e-3, 1e-3);
  Point sum;
  double torque = 0.0;
  double size = 0.0;
  for (Index t = 0; t < bodies.mesh().triangles(); ++t) {
    for (Index k = 0; k < 3; ++k) {
      const Point force = bodies.corner_force(t, k);
      sum = sum + force;
      torque += cross(bodies.corner(t, k), force);
      size += size_of(force);
    }
  }
  EXPECT_GT(size, 0.0);
  EXPECT_NEAR(sum.x, 0.0, 1e-14 * size);
  EXPECT_NEAR(sum.y, 0.0, 1e-14 * size);
  EXPECT_NEAR(torque, 0.0, 1e-14 * size);
}

TEST(ContactStates, EveryCornerForceIsTheDerivativeOfTheReportedEnergy) {
  test::Bodies bodies = test::Bodies::of({test::floor_triangle, test::pointed}, {1e9, 0.0, 0.0});
  bodies.advance();
  bodies.move(1, {0.1, -0.2});
  for (Index t = 0; t < 2; ++t) {
    for (Index k = 0; k < 3; ++k) {
      const double step = 1e-6;
      const auto energy = [&](double by) {
        bodies.uy()[bodies.slot(t, k)] += by;
        bodies.advance(1.0);
        const double value = bodies.potential_energy();
        bodies.uy()[bodies.slot(t, k)] -= by;
        return value;
      };
      const double slope = (energy(step) - energy(-step)) / (2.0 * step);
      bodies.advance();
      EXPECT_NEAR(bodies.corner_force(t, k).y, -slope, 1e-6 * size_of(bodies.force(1)));
    }
  }
}

}  // namespace
}  // namespace percolith::mechanics
