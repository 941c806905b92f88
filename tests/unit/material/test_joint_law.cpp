// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/material/friction.hpp"
#include "percolith/material/joint_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace percolith::material {
namespace {

constexpr double stiffness = 2e12;
constexpr double tensile = 3e6;
constexpr double cohesion = 7e6;
constexpr double friction = 0.6;
constexpr double mode_1 = 40.0;
constexpr double mode_2 = 90.0;

JointConstants<double> rock() {
  return {stiffness,
          tensile,
          cohesion,
          friction,
          softening_integral * tensile / mode_1,
          softening_integral * cohesion / mode_2};
}

/// A point of a joint that is moved about.
struct Point {
  JointConstants<double> constants = rock();
  JointMemory<double> memory{};
  JointTraction<double> move(double opening, double slip) {
    return softening_traction(constants, opening, slip, memory);
  }
};

double opening_at_peak() {
  return tensile / stiffness;
}
double opening_range() {
  return mode_1 / (softening_integral * tensile);
}
double slip_range() {
  return mode_2 / (softening_integral * cohesion);
}

/// Munjiza's curve with the exponential of the library.
double curve(double d) {
  const double a = 0.63;
  const double b = 1.8;
  const double c = 6.0;
  return (1 - (a + b - 1) / (a + b) * std::exp(d * (a + c * b / ((a + b) * (1 - a - b))))) *
         (a * (1 - d) + b * std::pow(1 - d, c));
}

TEST(Softening, IsMunjizasCurve) {
  EXPECT_DOUBLE_EQ(softening(0.0), 1.0);
  EXPECT_EQ(softening(1.0), 0.0);
  for (int i = 0; i <= 1000; ++i) {
    EXPECT_NEAR(softening(i / 1000.0), curve(i / 1000.0), 2e-11);
  }
}

TEST(Softening, FallsFromPeakToEnd) {
  for (int i = 0; i < 1000; ++i) {
    EXPECT_GT(softening(i / 1000.0), softening((i + 1) / 1000.0));
  }
}

TEST(Softening, IntegralIsTheConstantOfTheEnergies) {
  constexpr int n = 10000;  // Simpson
  double sum = curve(0.0) + curve(1.0);
  for (int i = 1; i < n; ++i) {
    sum += (i % 2 == 1 ? 4 : 2) * curve(static_cast<double>(i) / n);
  }
  EXPECT_NEAR(sum / (3 * n), softening_integral, 1e-12);
  EXPECT_NEAR(softening_integral, 0.36309, 5e-6);
}

TEST(JointLaw, SlopeBeforeThePeakIsTheSameInAllDirections) {
  Point point;
  const auto pulled = point.move(1e-6, 0.0);
  EXPECT_DOUBLE_EQ(pulled.normal, stiffness * 1e-6);
  const auto pressed = point.move(-4e-6, 2e-6);
  EXPECT_DOUBLE_EQ(pressed.normal, -stiffness * 4e-6);
  EXPECT_DOUBLE_EQ(pressed.shear, stiffness * 2e-6);
  EXPECT_EQ(point.memory.damage, 0.0);
}

TEST(JointLaw, TensionPeaksAtTheTensileStrength) {
  Point point;
  double largest = 0.0;
  for (int i = 0; i <= 40000; ++i) {
    largest = std::max(largest,
                       point.move(i / 40000.0 * (opening_at_peak() + opening_range()), 0.0).normal);
  }
  EXPECT_NEAR(largest, tensile, 1e-3 * tensile);
  EXPECT_LE(largest, tensile);
}

TEST(JointLaw, ShearPeaksAtCohesionAndFriction) {
  for (const double pressure : {0.0, 2e6, 30e6}) {
    Point point;
    double largest = 0.0;
    for (int i = 0; i <= 40000; ++i) {
      largest =
          std::max(largest, point.move(-pressure / stiffness, -i / 40000.0 * 1e-4).shear * -1.0);
    }
    const double strength = cohesion + friction * pressure;
    EXPECT_NEAR(largest, strength, 1e-3 * strength);
    EXPECT_LE(largest, strength * (1 + 1e-12));
  }
}

TEST(JointLaw, OpeningSpendsTheEnergyOfModeOneAfterThePeak) {
  Point point;
  constexpr int n = 20000;
  const double step = opening_range() / n;
  double energy = 0.0;
  for (int i = 0; i <= n; ++i) {
    const double weight = i == 0 || i == n ? 0.5 : 1.0;
    energy += weight * step * point.move(opening_at_peak() + i * step, 0.0).normal;
  }
  EXPECT_NEAR(energy, mode_1, 1e-4 * mode_1);
  EXPECT_NEAR(point.memory.damage, 1.0, 1e-12);
  EXPECT_EQ(point.move(opening_at_peak() + 1.001 * opening_range(), 0.0).normal, 0.0);
}

TEST(JointLaw, SlidingSpendsTheEnergyOfModeTwoAboveFriction) {
  for (const double pressure : {0.0, 5e6}) {
    Point point;
    constexpr int n = 20000;
    const double at_peak = (cohesion + friction * pressure) / stiffness;
    const double step = slip_range() / n;
    double energy = 0.0;
    for (int i = 0; i <= n; ++i) {
      const double weight = i == 0 || i == n ? 0.5 : 1.0;
      const double shear = point.move(-pressure / stiffness, at_peak + i * step).shear;
      energy += weight * step * (shear - friction * pressure);
    }
    EXPECT_NEAR(energy, mode_2, 1e-4 * mode_2);
    EXPECT_NEAR(point.memory.damage, 1.0, 1e-9);
  }
}

TEST(JointLaw, OnAStraightMixedPathEachModeSpendsItsShare) {
  // (10): D is the length of the path in shares of the ranges, here equal in both.
  Point point;
  constexpr int n = 20000;
  double opened = 0.0;
  double slid = 0.0;
  for (int i = 0; i <= n; ++i) {
    const double x = std::sqrt(0.5) * i / n;
    const auto t = point.move(opening_at_peak() + x * opening_range(),
                              cohesion / stiffness + x * slip_range());
    EXPECT_NEAR(point.memory.damage, static_cast<double>(i) / n, 1e-9);
    const double weight = (i == 0 || i == n ? 0.5 : 1.0) * std::sqrt(0.5) / n;
    opened += weight * opening_range() * t.normal;
    slid += weight * slip_range() * t.shear;
  }
  EXPECT_NEAR(opened, std::sqrt(0.5) * mode_1, 1e-4 * mode_1);
  EXPECT_NEAR(slid, std::sqrt(0.5) * mode_2, 1e-4 * mode_2);
}

TEST(JointLaw, UnloadingFollowsTheSecant) {
  Point point;
  const double far = opening_at_peak() + 0.3 * opening_range();
  const double traction = point.move(far, 0.0).normal;
  EXPECT_NEAR(traction, curve(0.3) * tensile, 1e-6 * tensile);
  for (const double share : {0.7, 0.2, 0.0, 0.5, 1.0}) {
    EXPECT_NEAR(point.move(share * far, 0.0).normal, share * traction, 1e-9 * tensile);
    EXPECT_NEAR(point.memory.damage, 0.3, 1e-12);
  }
  const auto moment =
      moment_of(point.constants, far, 0.0, JointTraction<double>{traction, 0.0}, point.memory);
  EXPECT_NEAR(stored_energy(point.constants, moment), 0.5 * traction * far, 1e-12);
}

TEST(JointLaw, ClosingADamagedPointFindsTheFullStiffness) {
  Point point;
  point.move(opening_at_peak() + 0.9 * opening_range(), 0.0);
  EXPECT_DOUBLE_EQ(point.move(-1e-6, 0.0).normal, -stiffness * 1e-6);
}

TEST(JointLaw, FrictionIsLeftWhenTheBondIsGone) {
  Point point;
  const double far = 2 * slip_range() + cohesion / stiffness;
  point.move(-1e-6, far);
  EXPECT_EQ(point.memory.damage, 1.0);
  const double limit = friction * stiffness * 1e-6;
  EXPECT_NEAR(point.move(-1e-6, far).shear, limit, 1e-9 * limit);
  // Back by a little the spring of friction gives way, by more the faces slide back.
  EXPECT_NEAR(point.move(-1e-6, far - 0.5e-6).shear, limit - stiffness * 0.5e-6, 1e-6 * limit);
  EXPECT_NEAR(point.move(-1e-6, 0.5 * far).shear, -limit, 1e-9 * limit);
  EXPECT_NEAR(point.move(-3e-6, 1.5 * far).shear, 3 * limit, 1e-9 * limit);
  EXPECT_EQ(point.move(0.0, far).shear, 0.0);
}

TEST(JointLaw, DamageNeverHealsOnAnyPath) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> opening(-0.5 * opening_range(), 0.8 * opening_range());
  std::uniform_real_distribution<double> slip(-0.8 * slip_range(), 0.8 * slip_range());
  for (int path = 0; path < 200; ++path) {
    Point point;
    double before = 0.0;
    for (int i = 0; i < 30; ++i) {
      const auto t = point.move(opening(random), slip(random));
      EXPECT_GE(point.memory.damage, before);
      EXPECT_LE(point.memory.damage, 1.0);
      EXPECT_LE(t.normal, softening(point.memory.damage) * tensile * (1 + 1e-12));
      before = point.memory.damage;
    }
  }
}

TEST(JointLaw, NoCycleGivesEnergyBack) {
  // Whatever way a point is led, what bond and friction lose never falls, and work, storage and
  // losses add up.
  std::mt19937 random(7);
  std::uniform_real_distribution<double> opening(-1.0 * opening_range(), 0.3 * opening_range());
  std::uniform_real_distribution<double> slip(-0.5 * slip_range(), 0.5 * slip_range());
  for (int path = 0; path < 100; ++path) {
    Point point;
    JointMoment<double> last{0.0, 0.0, {0.0, 0.0}, stiffness, 0.0, 0.0};
    double work = 0.0;
    double lost = 0.0;
    for (int leg = 0; leg < 12; ++leg) {
      const double o = opening(random);
      const double s = slip(random);
      const double from_o = last.opening;
      const double from_s = last.slip;
      constexpr int n = 4000;
      for (int i = 1; i <= n; ++i) {
        const double x = static_cast<double>(i) / n;
        const double now_o = from_o + x * (o - from_o);
        const double now_s = from_s + x * (s - from_s);
        const auto t = point.move(now_o, now_s);
        const auto now = moment_of(point.constants, now_o, now_s, t, point.memory);
        work += 0.5 * ((last.traction.normal + t.normal) * (now_o - last.opening) +
                       (last.traction.shear + t.shear) * (now_s - last.slip));
        const auto loss = joint_loss(point.constants, last, now);
        EXPECT_GE(loss.bond, -1e-6 * mode_1) << path << ' ' << leg << ' ' << i;
        EXPECT_GE(loss.friction, -1e-6 * mode_1) << path << ' ' << leg << ' ' << i;
        lost += loss.bond + loss.friction;
        last = now;
      }
    }
    EXPECT_NEAR(work, lost + stored_energy(point.constants, last), 1e-3 * work);
  }
}

TEST(JointLaw, BelowThePeakBothFormsGiveTheSameBits) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> opening(-5e-6, 1.2 * opening_at_peak());
  std::uniform_real_distribution<double> slip(-8e-6, 8e-6);
  int below = 0;
  int above = 0;
  for (int i = 0; i < 10000; ++i) {
    const double o = opening(random);
    const double s = slip(random);
    Point point;
    const auto elastic = elastic_traction(stiffness, o, s);
    const auto t = point.move(o, s);
    if (exceeds_strength(point.constants, elastic)) {
      ++above;
      EXPECT_GT(point.memory.damage, 0.0);
      continue;
    }
    ++below;
    EXPECT_EQ(t.normal, elastic.normal);
    EXPECT_EQ(t.shear, elastic.shear);
    EXPECT_EQ(point.memory.damage, 0.0);
    EXPECT_EQ(point.memory.opening_peak, 0.0);
    EXPECT_EQ(point.memory.slip_peak, 0.0);
  }
  EXPECT_GT(below, 1000);
  EXPECT_GT(above, 1000);
}

TEST(JointLaw, LanesGiveTheBitsOfSingleNumbers) {
  using Real = VectorLane::Real;
  const JointConstants<double> c = rock();
  const JointConstants<Real> wide{Real(c.stiffness), Real(c.tensile),       Real(c.cohesion),
                                  Real(c.friction),  Real(c.opening_range), Real(c.slip_range)};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-0.5, 1.0);
  for (int i = 0; i < 300; ++i) {
    const Real opening([&](auto) { return place(random) * opening_range(); });
    const Real slip([&](auto) { return place(random) * slip_range(); });
    JointMemory<Real> memory{Real(0.0), Real(0.0), Real(0.1), Real(1e11), Real(2e6), Real(1e-6)};
    const auto t = softening_traction(wide, opening, slip, memory);
    for (std::size_t k = 0; k < Real::size(); ++k) {
      JointMemory<double> single{0.0, 0.0, 0.1, 1e11, 2e6, 1e-6};
      const auto expected = softening_traction(c, opening[k], slip[k], single);
      EXPECT_EQ(t.normal[k], expected.normal);
      EXPECT_EQ(t.shear[k], expected.shear);
      EXPECT_EQ(memory.damage[k], single.damage);
    }
  }
}

TEST(JointLaw, WithoutStiffnessNothingIsCarried) {
  Point point;
  point.constants.stiffness = 0.0;
  for (const double o : {-1.0, 0.0, 1.0}) {
    const auto t = point.move(o, 2.0);
    EXPECT_EQ(t.normal, 0.0);
    EXPECT_EQ(t.shear, 0.0);
    EXPECT_EQ(point.memory.damage, 0.0);
  }
}

TEST(JointLaw, WithHardlyAnyCohesionFrictionLimitsTheShear) {
  Point point;
  point.constants.cohesion = 1e-3;
  point.constants.slip_range = softening_integral * 1e-3 / mode_2;
  const double pressed = -4e-6;
  const double limit = friction * 4e-6 * stiffness;
  EXPECT_NEAR(point.move(pressed, 1e-6).shear, 1e-6 * stiffness, 1e-3);
  for (const double slip : {3e-6, 1e-5, 1e-3}) {
    EXPECT_NEAR(point.move(pressed, slip).shear, limit, 1e-8 * limit);
  }
}

TEST(Friction, SticksSlidesAndLosesWhatItDoesNotStore) {
  const auto stuck = friction_step(1.0, 10.0, 0.05, 2.0);
  EXPECT_DOUBLE_EQ(stuck.force, 0.5);
  EXPECT_EQ(stuck.slip, 0.0);
  EXPECT_EQ(stuck.loss, 0.0);
  const auto slid = friction_step(1.0, 10.0, 0.5, 2.0);  // trial -4
  EXPECT_DOUBLE_EQ(slid.force, -2.0);
  EXPECT_DOUBLE_EQ(slid.slip, -0.2);
  const double work = 0.5 * (1.0 - 2.0) * 0.5;  // of the force on the body
  const double stored = 0.5 * (4.0 - 1.0) / 10.0;
  EXPECT_NEAR(slid.loss, -work - stored, 1e-15);
  const auto other = friction_step(0.0, 10.0, -1.0, 3.0);
  EXPECT_DOUBLE_EQ(other.force, 3.0);
  EXPECT_DOUBLE_EQ(other.slip, 0.7);
  EXPECT_DOUBLE_EQ(other.loss, 1.05);
}

}  // namespace
}  // namespace percolith::material
