// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/material/friction.hpp"

#include <gtest/gtest.h>

#include "unit/mechanics/test_contact_support.hpp"

namespace percolith::mechanics {
namespace {

TEST(ContactFriction, SticksBelowTheLimitAndSlidesAtIt) {
  const auto stuck = material::friction_step(1.0, 10.0, 0.2, 5.0);
  EXPECT_DOUBLE_EQ(stuck.force, -1.0);
  EXPECT_DOUBLE_EQ(stuck.slip, 0.0);
  EXPECT_DOUBLE_EQ(stuck.loss, 0.0);
  const auto sliding = material::friction_step(-5.0, 10.0, 0.2, 5.0);
  EXPECT_DOUBLE_EQ(sliding.force, -5.0);
  EXPECT_DOUBLE_EQ(sliding.slip, -0.2);
  EXPECT_DOUBLE_EQ(sliding.loss, 1.0);
  // A limit that falls releases part of the spring: (5^2 - 3^2) / (2 10).
  EXPECT_DOUBLE_EQ(material::friction_step(5.0, 10.0, 0.0, 3.0).loss, 0.8);
}

/// The small triangle pressed onto the floor, and moved along it.
struct Slider {
  test::Bodies bodies;
  double depth = 1e-3;
  double moved = 0.0, work = 0.0;

  explicit Slider(const test::Material& material)
      : bodies(test::Bodies::of({test::floor_triangle, test::flat}, material)) {
    bodies.advance();
    bodies.move(1, {0.0, -depth});
    bodies.advance(depth, 1.0);
  }
  void slide(double by) {
    const double before = bodies.force(1).x;
    bodies.set_velocity(1, {by, 0.0});
    bodies.move(1, {by, 0.0});
    bodies.advance(std::abs(by), 1.0);
    moved += by;
    work -= 0.5 * (before + bodies.force(1).x) * by;
  }
};

// The contact is as long as the lower edge of the small triangle, 1 m.
TEST(ContactFriction, TheTangentialForceGrowsWithTheWay) {
  const test::Material material{1e9, 2e9, 0.5};
  Slider slider(material);
  slider.slide(1e-7);
  EXPECT_NEAR(slider.bodies.force(1).x, -material.tangential_penalty * 1e-7,
              1e-9 * material.tangential_penalty * 1e-7);
  slider.slide(-2e-7);
  EXPECT_NEAR(slider.bodies.force(1).x, material.tangential_penalty * 1e-7,
              1e-9 * material.tangential_penalty * 1e-7);
  EXPECT_NEAR(slider.bodies.contact().friction_dissipation(), 0.0, 1e-9);
  EXPECT_NEAR(slider.bodies.contact().stored_tangential(),
              0.5 * material.tangential_penalty * 1e-14, 1e-9);
}

TEST(ContactFriction, ReachesCoulombsLimitAndBooksTheWorkOfSliding) {
  const test::Material material{1e9, 2e10, 0.5};
  Slider slider(material);
  const double pressed = slider.bodies.force(1).y;
  const double stored = slider.bodies.contact().stored_tangential();
  for (int i = 0; i < 100; ++i) {
    slider.slide(1e-5);
  }
  EXPECT_NEAR(slider.bodies.force(1).y, pressed, 1e-3 * pressed);
  EXPECT_NEAR(slider.bodies.force(1).x, -0.5 * slider.bodies.force(1).y,
              1e-9 * slider.bodies.force(1).y);
  const double held = slider.bodies.contact().stored_tangential() - stored;
  EXPECT_GT(slider.bodies.contact().friction_dissipation(), 0.0);
  EXPECT_NEAR(slider.bodies.contact().friction_dissipation() + held, slider.work,
              1e-6 * slider.work);
}

TEST(ContactFriction, ActsAtTheSamePointOnBothTriangles) {
  Slider slider({1e9, 2e10, 0.5});
  slider.slide(1e-4);
  Point sum;
  double torque = 0.0;
  for (Index t = 0; t < 2; ++t) {
    for (Index k = 0; k < 3; ++k) {
      sum = sum + slider.bodies.corner_force(t, k);
      torque += cross(slider.bodies.corner(t, k), slider.bodies.corner_force(t, k));
    }
  }
  const double scale = slider.bodies.force(1).y;
  EXPECT_LT(slider.bodies.force(1).x, -0.1 * scale);
  EXPECT_NEAR(sum.x, 0.0, 1e-14 * scale);
  EXPECT_NEAR(sum.y, 0.0, 1e-14 * scale);
  EXPECT_NEAR(torque, 0.0, 1e-13 * scale);
}

TEST(ContactFriction, TheSmoothSideOfAPairDecides) {
  test::Material smooth;
  smooth.friction = 0.0;
  Slider slider(smooth);
  slider.slide(1e-4);
  EXPECT_NEAR(slider.bodies.force(1).x, 0.0, 1e-12 * slider.bodies.force(1).y);
  EXPECT_DOUBLE_EQ(slider.bodies.contact().friction_dissipation(), 0.0);
}

TEST(ContactFriction, WhatTheSpringHeldIsLostWhenTheFacesPart) {
  Slider slider({});
  slider.slide(1e-7);
  const double stored = slider.bodies.contact().stored_tangential();
  ASSERT_GT(stored, 0.0);
  slider.bodies.set_velocity(1, {});
  slider.bodies.move(1, {0.0, 0.1});
  slider.bodies.advance(0.1, 1.0);
  EXPECT_EQ(slider.bodies.force(1), (Point{0.0, 0.0}));
  EXPECT_DOUBLE_EQ(slider.bodies.contact().stored_tangential(), 0.0);
  EXPECT_NEAR(slider.bodies.contact().friction_dissipation(), stored, 1e-12 * stored);
}

}  // namespace
}  // namespace percolith::mechanics
