// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/material/elasticity.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace percolith::material {
namespace {

ElasticRock isotropic(double e = 20e9, double nu = 0.23) {
  ElasticRock rock;
  rock.density = 2600.0;
  rock.young_modulus = e;
  rock.poisson_ratio = nu;
  return rock;
}

ElasticRock layered(double angle) {
  ElasticRock rock = isotropic(30e9, 0.2);
  rock.normal_young_modulus = 12e9;
  rock.normal_poisson_ratio = 0.11;
  rock.normal_shear_modulus = 4e9;
  rock.bedding_angle = angle;
  return rock;
}

void expect_near(const PlaneStiffness<double>& a, const PlaneStiffness<double>& b, double error) {
  EXPECT_NEAR(a.xx_xx, b.xx_xx, error);
  EXPECT_NEAR(a.xx_yy, b.xx_yy, error);
  EXPECT_NEAR(a.yy_yy, b.yy_yy, error);
  EXPECT_NEAR(a.xx_xy, b.xx_xy, error);
  EXPECT_NEAR(a.yy_xy, b.yy_xy, error);
  EXPECT_NEAR(a.xy_xy, b.xy_xy, error);
}

/// The stiffness tensor C_ijkl of the plane from its Voigt entries.
double component(const PlaneStiffness<double>& d, int i, int j, int k, int l) {
  const std::array<std::array<double, 3>, 3> voigt{
      {{d.xx_xx, d.xx_yy, d.xx_xy}, {d.xx_yy, d.yy_yy, d.yy_xy}, {d.xx_xy, d.yy_xy, d.xy_xy}}};
  const auto row = [](int a, int b) { return static_cast<std::size_t>(a == b ? a : 2); };
  return voigt[row(i, j)][row(k, l)];
}

/// C'_ijkl = R_ip R_jq R_kr R_ls C_pqrs, R the rotation by `angle`.
double rotated(const PlaneStiffness<double>& d, double angle, std::array<int, 4> index) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const std::array<std::array<double, 2>, 2> r{{{c, -s}, {s, c}}};
  double sum = 0.0;
  for (int n = 0; n < 16; ++n) {
    const std::array<int, 4> from{n & 1, n >> 1 & 1, n >> 2 & 1, n >> 3 & 1};
    double product = component(d, from[0], from[1], from[2], from[3]);
    for (std::size_t m = 0; m < 4; ++m) {
      product *= r[static_cast<std::size_t>(index[m])][static_cast<std::size_t>(from[m])];
    }
    sum += product;
  }
  return sum;
}

TEST(Elasticity, IsotropicRockFollowsTheTextbook) {
  const double e = 20e9;
  const double nu = 0.23;
  const double g = e / (2 * (1 + nu));
  const double lambda = 2 * g * nu / (1 - 2 * nu);
  expect_near(plane_stiffness(isotropic(), Plane::strain),
              {lambda + 2 * g, lambda, lambda + 2 * g, 0.0, 0.0, g}, 1.0);
  const double f = e / (1 - nu * nu);
  expect_near(plane_stiffness(isotropic(), Plane::stress), {f, nu * f, f, 0.0, 0.0, g}, 1.0);
}

TEST(Elasticity, StressAcrossThePlaneIsThatOfNoStrainThere) {
  const Tensor strain{1e-3, -4e-4, 7e-4};
  const Tensor s = stress_of(plane_stiffness(isotropic(), Plane::strain), strain);
  const AcrossStiffness d = across_stiffness(isotropic(), Plane::strain);
  EXPECT_NEAR(d.xx * strain.xx + d.yy * strain.yy + d.xy * 2 * strain.xy, 0.23 * (s.xx + s.yy),
              1e-3);
  const AcrossStiffness none = across_stiffness(layered(0.4), Plane::stress);
  EXPECT_EQ(none.xx, 0.0);
  EXPECT_EQ(none.yy, 0.0);
  EXPECT_EQ(none.xy, 0.0);
}

/// The plane and the strike of layered rock without strain along the strike: entries of the inverse
/// of the full compliance of the three normal directions.
TEST(Elasticity, PlaneStrainOfLayeredRockInvertsTheFullCompliance) {
  const ElasticRock rock = layered(0.0);
  const double a = 1 / 30e9;
  const double b = -0.11 / 12e9;  // along and across
  const double c = -0.2 / 30e9;   // along and strike
  const double d = 1 / 12e9;
  // Symmetric compliance of (along, across, strike): [a b c; b d b; c b a].
  const double determinant = a * (d * a - b * b) - b * (b * a - b * c) + c * (b * b - d * c);
  const PlaneStiffness<double> k = plane_stiffness(rock, Plane::strain);
  EXPECT_NEAR(k.xx_xx, (d * a - b * b) / determinant, 1.0);
  EXPECT_NEAR(k.xx_yy, (c * b - b * a) / determinant, 1.0);
  EXPECT_NEAR(k.yy_yy, (a * a - c * c) / determinant, 1.0);
  EXPECT_EQ(k.xy_xy, 4e9);
  const AcrossStiffness across = across_stiffness(rock, Plane::strain);
  EXPECT_NEAR(across.xx, (b * b - c * d) / determinant, 1.0);
  EXPECT_NEAR(across.yy, (b * c - a * b) / determinant, 1.0);
  EXPECT_EQ(across.xy, 0.0);
}

TEST(Elasticity, BeddingAngleRotatesTheTensor) {
  for (const Plane plane : {Plane::strain, Plane::stress}) {
    const PlaneStiffness<double> level = plane_stiffness(layered(0.0), plane);
    for (const double angle : {0.3, 1.1, -0.7, 2.5}) {
      const PlaneStiffness<double> d = plane_stiffness(layered(angle), plane);
      expect_near(d,
                  {rotated(level, angle, {0, 0, 0, 0}), rotated(level, angle, {0, 0, 1, 1}),
                   rotated(level, angle, {1, 1, 1, 1}), rotated(level, angle, {0, 0, 0, 1}),
                   rotated(level, angle, {1, 1, 0, 1}), rotated(level, angle, {0, 1, 0, 1})},
                  10.0);
    }
  }
}

TEST(Elasticity, AcrossStressTurnsWithTheBedding) {
  const double angle = 0.6;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  // A strain along the layers, seen from x and y, strains the layers as one along x at angle 0.
  const Tensor strain{c * c, s * s, c * s};
  const AcrossStiffness d = across_stiffness(layered(angle), Plane::strain);
  EXPECT_NEAR(d.xx * strain.xx + d.yy * strain.yy + d.xy * 2 * strain.xy,
              across_stiffness(layered(0.0), Plane::strain).xx, 10.0);
}

TEST(Elasticity, LayersOfEqualStiffnessAreIsotropic) {
  for (const double angle : {0.0, 0.5, 1.3}) {
    ElasticRock rock = isotropic();
    rock.normal_young_modulus = rock.young_modulus;
    rock.bedding_angle = angle;
    for (const Plane plane : {Plane::strain, Plane::stress}) {
      expect_near(plane_stiffness(rock, plane), plane_stiffness(isotropic(), plane), 10.0);
    }
  }
}

TEST(Elasticity, SaintVenantShearModulusWhereNoneIsGiven) {
  ElasticRock rock = layered(0.0);
  rock.normal_shear_modulus.reset();
  EXPECT_NEAR(plane_stiffness(rock, Plane::strain).xy_xy, 1 / (1.22 / 12e9 + 1 / 30e9), 1.0);
}

TEST(Elasticity, EveryStrainCostsEnergy) {
  for (const double angle : {0.0, 0.4, 0.9}) {
    const PlaneStiffness<double> d = plane_stiffness(layered(angle), Plane::strain);
    for (int i = 0; i < 60; ++i) {
      const double a = i * std::numbers::pi / 60;
      for (int j = 0; j < 60; ++j) {
        const double b = j * std::numbers::pi / 30;
        const Tensor e{std::cos(a), std::sin(a) * std::cos(b), std::sin(a) * std::sin(b)};
        const Tensor s = stress_of(d, e);
        EXPECT_GT(s.xx * e.xx + s.yy * e.yy + 2 * s.xy * e.xy, 0.1e9);
      }
    }
  }
}

TEST(Elasticity, ModulusOfThePlane) {
  EXPECT_NEAR(plane_modulus(isotropic(), Plane::strain), 20e9 / (1 - 0.23 * 0.23), 10.0);
  EXPECT_NEAR(plane_modulus(isotropic(), Plane::stress), 20e9, 10.0);
  EXPECT_NEAR(plane_modulus(layered(0.0), Plane::stress), 30e9, 10.0);
  EXPECT_NEAR(plane_modulus(layered(std::numbers::pi / 2), Plane::stress), 12e9, 10.0);
}

TEST(Elasticity, ModulusAskewOfTheBedding) {
  // 1/E(theta) = cos^4/E + sin^4/E_n + sin^2 cos^2 (1/G_n - 2 nu_n/E_n).
  const double c2 = std::pow(std::cos(0.5), 2);
  const double s2 = 1 - c2;
  const double compliance = c2 * c2 / 30e9 + s2 * s2 / 12e9 + c2 * s2 * (1 / 4e9 - 2 * 0.11 / 12e9);
  EXPECT_NEAR(plane_modulus(layered(0.5), Plane::stress), 1 / compliance, 100.0);
}

TEST(Elasticity, WaveSpeeds) {
  const double g = 20e9 / 2.46;
  const double lambda = 2 * g * 0.23 / 0.54;
  const WaveSpeeds speeds = wave_speeds(isotropic(), Plane::strain);
  EXPECT_NEAR(speeds.compression, std::sqrt((lambda + 2 * g) / 2600), 1e-6);
  EXPECT_NEAR(speeds.shear, std::sqrt(g / 2600), 1e-6);
  const PlaneStiffness<double> d = plane_stiffness(layered(0.0), Plane::strain);
  EXPECT_NEAR(wave_speeds(layered(0.7), Plane::strain).compression, std::sqrt(d.xx_xx / 2600),
              1e-6);
}

}  // namespace
}  // namespace percolith::material
