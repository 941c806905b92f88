// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/joint_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "unit/support/solid_model.hpp"

namespace percolith::mechanics {
namespace {

using test::at;

double size(Point p) {
  return std::sqrt(dot(p, p));
}

/// Two triangles of a unit square and the joint between them.
Model square(const JointKind& kind = test::strong()) {
  return test::make_solid(test::make_grid({.columns = 1, .rows = 1}), {.kind = kind});
}

/// Moves the triangle of side 1 of joint 0.
template <class Field>
void move_side_one(Model& model, const Field& field) {
  for (Index k = 0; k < 3; ++k) {
    const Index c = mesh::corner_of(mesh::triangle_of(model.mesh.joint[0].corner[1][0]), k);
    const Point u = field(model.mesh.place_of(c));
    model.motion.ux[at(c)] = u.x;
    model.motion.uy[at(c)] = u.y;
  }
}

Point across_of(const Model& model) {
  const Point along =
      (1.0 / model.mesh.joint_length(0)) * Point{model.joints.ex[0], model.joints.ey[0]};
  return clockwise(along);
}

TEST(Joints, GaussWeightsIntegrateCubicsExactly) {
  // Points x = g along a joint of length 1, half of the length each.
  for (int power = 0; power <= 3; ++power) {
    const double sum = 0.5 * (std::pow(gauss_weight(0), power) + std::pow(gauss_weight(1), power));
    EXPECT_NEAR(sum, 1.0 / (power + 1), 1e-15);
  }
}

TEST(Joints, SizeAndStiffnessAreThoseOfTheElements) {
  const Model model = square();
  // The equilateral triangle of area 1/2 has the edge 2 sqrt(A/sqrt 3).
  const double h = 2 * std::sqrt(0.5 / std::sqrt(3.0));
  EXPECT_NEAR(model.joints.size[0], h, 1e-15);
  EXPECT_NEAR(model.joints.full_stiffness[0], 20 * 10e9 / h, 1.0);
  JointKind soft = test::strong();
  soft.strength.joint_penalty = 3e9;
  EXPECT_NEAR(square(soft).joints.stiffness[0], 3e9 / h, 1e-3);
}

TEST(Joints, OpeningAndSlipAreReadInTheFrameOfTheJoint) {
  Model model = square();
  const Point across = across_of(model);
  const Point along{-across.y, across.x};
  move_side_one(model, [&](Point) { return 3e-6 * across + 2e-6 * along; });
  const JointPoints points = joint_points(model, joint_table(model), 0);
  for (std::size_t g = 0; g < 2; ++g) {
    EXPECT_NEAR(points.opening[g], 3e-6, 1e-11);
    EXPECT_NEAR(points.slip[g], 2e-6, 1e-11);
    EXPECT_NEAR(points.traction[g].normal, model.joints.stiffness[0] * 3e-6, 1e-4 * 1e6);
  }
}

TEST(Joints, ForcesObeyTheThirdLawAndCarryTheMoment) {
  Model model = square();
  const Point across = across_of(model);
  const Point from = model.mesh.vertex[at(model.mesh.joint[0].vertex[0])];
  // An opening that grows along the joint.
  move_side_one(model, [&](Point p) { return 1e-6 * (1 + size(p - from)) * across; });
  const std::vector<Point> force = test::joint_forces_of(model);
  const auto& corner = model.mesh.joint[0].corner;
  for (std::size_t end = 0; end < 2; ++end) {
    const Point a = force[at(corner[0][end])];
    const Point b = force[at(corner[1][end])];
    EXPECT_EQ(a.x, -b.x);
    EXPECT_EQ(a.y, -b.y);
    EXPECT_GT(dot(a, across), 0.0) << "an open joint pulls side 0 towards side 1";
  }
  // Traction k 1e-6 (1 + x) over the length L: force and moment about end 0.
  const double length = model.mesh.joint_length(0);
  const double k = model.joints.stiffness[0] * 1e-6;
  const double at_0 = dot(force[at(corner[0][0])], across);
  const double at_1 = dot(force[at(corner[0][1])], across);
  EXPECT_NEAR(at_0 + at_1, k * (length + 0.5 * length * length), 1e-5 * k);
  EXPECT_NEAR(at_1 * length, k * (0.5 * std::pow(length, 2) + std::pow(length, 3) / 3), 1e-5 * k);
}

TEST(Joints, RigidMotionOfBothSidesGivesNoForce) {
  Model model = test::make_solid(test::make_grid({.columns = 3, .rows = 3, .jitter = 0.2}));
  for (const double angle : {0.3, 1.7, 4.0}) {
    test::displace(model, [&](Point p) {
      return Point{std::cos(angle) * p.x - std::sin(angle) * p.y - p.x + 3.0,
                   std::sin(angle) * p.x + std::cos(angle) * p.y - p.y - 1.0};
    });
    for (const Point& f : test::joint_forces_of(model)) {
      EXPECT_LT(size(f), 1e-13 * 20 * 10e9);
    }
  }
}

TEST(Joints, ForcesTurnWithTheJoint) {
  Model model = test::make_solid(test::make_grid({.columns = 3, .rows = 3, .jitter = 0.2}),
                                 {.kind = test::joint_kind(2e6, 5e6, 50.0, 90.0)});
  std::mt19937 random(5);
  std::uniform_real_distribution<double> shift(-1.5e-5, 1.5e-5);
  std::vector<Point> moved(at(model.mesh.corners()));
  test::for_each_corner(model.mesh, [&](Index, Index c) {
    moved[at(c)] = {shift(random), shift(random)};
  });
  const auto place = [&](double angle) {
    test::for_each_corner(model.mesh, [&](Index, Index c) {
      const Point p = model.mesh.place_of(c);
      const Point q = p + moved[at(c)];
      model.motion.ux[at(c)] = std::cos(angle) * q.x - std::sin(angle) * q.y - p.x;
      model.motion.uy[at(c)] = std::sin(angle) * q.x + std::cos(angle) * q.y - p.y;
    });
  };
  Model fresh = model;
  place(0.0);
  const std::vector<Point> level = test::joint_forces_of(model);
  model.joints = fresh.joints;
  place(2.2);
  const std::vector<Point> turned = test::joint_forces_of(model);
  double damage = 0.0;
  test::for_each_corner(model.mesh, [&](Index, Index c) {
    const Point f = level[at(c)];
    const Point expected{std::cos(2.2) * f.x - std::sin(2.2) * f.y,
                         std::sin(2.2) * f.x + std::cos(2.2) * f.y};
    EXPECT_LT(size(turned[at(c)] - expected), 1e-2 + 1e-8 * size(f));
  });
  for (const double d : model.joints.damage[0]) {
    damage = std::max(damage, d);
  }
  EXPECT_GT(damage, 0.01);
}

TEST(Joints, MomentOfAllForcesVanishes) {
  // Damaged joints that open and slide: what both sides get turns nothing but for the small
  // distance between them.
  Model model = square(test::joint_kind(2e6, 5e6, 50.0, 90.0));
  const Point across = across_of(model);
  move_side_one(model, [&](Point p) { return 4e-5 * (1 + p.x) * across; });
  const std::vector<Point> force = test::joint_forces_of(model);
  double moment = 0.0;
  double largest = 0.0;
  test::for_each_corner(model.mesh, [&](Index, Index c) {
    moment += cross(model.mesh.place_of(c), force[at(c)]);
    largest = std::max(largest, size(force[at(c)]));
  });
  EXPECT_GT(model.joints.damage[0][0], 0.0);
  EXPECT_LT(std::abs(moment), 1e-12 * largest);
}

TEST(Joints, TheBlockRemembersThatItWasDamaged) {
  Model model = square(test::joint_kind(2e6, 5e6, 50.0, 90.0));
  const Point across = across_of(model);
  test::joint_forces_of(model);
  EXPECT_EQ(model.joints.condition[0], static_cast<std::uint8_t>(BlockCondition::whole));
  move_side_one(model, [&](Point) { return 3e-5 * across; });
  test::joint_forces_of(model);
  EXPECT_EQ(model.joints.condition[0], static_cast<std::uint8_t>(BlockCondition::damaged));
  const double damage = model.joints.damage[0][0];
  EXPECT_GT(damage, 0.1);
  // Back below the strength the joint is still the damaged one.
  move_side_one(model, [&](Point) { return 1e-6 * across; });
  const JointPoints points = joint_points(model, joint_table(model), 0);
  EXPECT_LT(points.traction[0].normal, 0.5 * model.joints.stiffness[0] * 1e-6);
  const std::vector<Point> force = test::joint_forces_of(model);
  EXPECT_NEAR(dot(force[at(model.mesh.joint[0].corner[0][0])], across),
              0.5 * model.mesh.joint_length(0) * points.traction[0].normal, 1e-6);
  move_side_one(model, [&](Point) { return 1e-3 * across; });
  test::joint_forces_of(model);
  EXPECT_EQ(model.joints.condition[0], static_cast<std::uint8_t>(BlockCondition::failed));
}

TEST(Joints, WeakerJointsSpendLessOverTheSameRange) {
  Model model = square(test::joint_kind(2e6, 5e6, 50.0, 90.0));
  model.joints.factor.assign(model.joints.ex.size(), 1.0);
  model.joints.factor[0] = 0.5;
  const JointTable table = joint_table(model);
  const Point across = across_of(model);
  const double range = 50.0 / (material::softening_integral * 2e6);
  const double peak = 1e6 / model.joints.stiffness[0];
  move_side_one(model, [&](Point) { return (peak + 0.5 * range) * across; });
  test::joint_forces_of(model);
  EXPECT_NEAR(model.joints.damage[0][0], 0.5, 1e-9);
  EXPECT_NEAR(joint_points(model, table, 0).traction[0].normal, material::softening(0.5) * 1e6,
              1.0);
}

TEST(Joints, StoredEnergyIsHalfTractionTimesOpening) {
  Model model = square();
  const Point across = across_of(model);
  move_side_one(model, [&](Point) { return 3e-6 * across; });
  const double expected = 0.5 * model.joints.stiffness[0] * 9e-12 * model.mesh.joint_length(0);
  Execution execution;
  EXPECT_NEAR(stored_in_joints(model, joint_table(model), execution), expected, 1e-5 * expected);
}

TEST(Joints, InSituStressIsInTheTractionFromTheStart) {
  Model model = square();
  const Tensor stress{-3e6, -5e6, 1e6};
  set_initial_stress(model, [&](Point) { return stress; });
  const Point across = across_of(model);
  const Point along{-across.y, across.x};
  const JointPoints points = joint_points(model, joint_table(model), 0);
  for (std::size_t g = 0; g < 2; ++g) {
    EXPECT_NEAR(points.traction[g].normal, dot(stress * across, across), 1e-6);
    EXPECT_NEAR(points.traction[g].shear, dot(stress * across, along), 1e-6);
  }
}

}  // namespace
}  // namespace percolith::mechanics
