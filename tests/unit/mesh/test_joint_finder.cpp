// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/joint_finder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "unit/support/grid.hpp"
#include "unit/support/places.hpp"

namespace percolith::mesh {
namespace {

using test::at;

TEST(NearestJoint, ProjectsOntoTheNearestOfTheGivenJoints) {
  const Mesh mesh = build_mesh(test::make_grid({.columns = 4, .rows = 4}));
  const std::vector<Index> joints{test::joint_between(mesh, {0.5, 0.25}, {0.5, 0.5}),
                                  test::joint_between(mesh, {0.5, 0.5}, {0.5, 0.75})};
  const auto place = nearest_joint(mesh, joints, {0.6, 0.55});
  ASSERT_TRUE(place);
  EXPECT_EQ(place->joint, joints[1]);
  EXPECT_NEAR(place->distance, 0.1, 1e-14);
  const auto& ends = mesh.joint[at(place->joint)].vertex;
  const double y = (1.0 - place->fraction) * mesh.vertex[at(ends[0])].y +
                   place->fraction * mesh.vertex[at(ends[1])].y;
  EXPECT_NEAR(y, 0.55, 1e-14);
  // Beyond an end the end itself is nearest.
  const auto beyond = nearest_joint(mesh, joints, {0.5, 0.95});
  EXPECT_NEAR(beyond->distance, 0.2, 1e-14);
  EXPECT_TRUE(beyond->fraction == 0.0 || beyond->fraction == 1.0);
  EXPECT_FALSE(nearest_joint(mesh, {}, {0.5, 0.5}));
}

TEST(JointFinder, FindsThoseWithinAShareOfTheirLengthNearestFirst) {
  const Mesh mesh = build_mesh(test::make_grid({.columns = 4, .rows = 4}));
  const std::vector<Index> joints{test::joint_between(mesh, {0.5, 0.25}, {0.5, 0.5}),
                                  test::joint_between(mesh, {0.5, 0.5}, {0.5, 0.75}),
                                  test::joint_between(mesh, {0.75, 0.5}, {0.75, 0.75})};
  const auto near = JointFinder(mesh, joints, 0.5).near({0.6, 0.55});
  ASSERT_EQ(near.size(), 2u);  // the third is 0.15 away, more than half its length of 0.25
  EXPECT_EQ(near[0].joint, joints[1]);
  EXPECT_NEAR(near[0].distance, 0.1, 1e-14);
  EXPECT_EQ(near[1].joint, joints[0]);
  EXPECT_NEAR(near[1].distance, std::hypot(0.1, 0.05), 1e-14);
  EXPECT_EQ(JointFinder(mesh, joints, 0.7).near({0.6, 0.55}).size(), 3u);
  EXPECT_TRUE(JointFinder(mesh, {}, 0.5).near({0.6, 0.55}).empty());
  EXPECT_TRUE(JointFinder(mesh, joints, 0.5).near({1e300, -1e30}).empty());
}

TEST(JointFinder, MissesNoneOfAnIrregularMesh) {
  const Mesh mesh = build_mesh(test::make_grid({.columns = 30,
                                                .rows = 3,
                                                .width = 6.0,
                                                .height = 0.5,
                                                .origin = {-2.0, 1.0},
                                                .jitter = 0.3}));
  std::vector<Index> joints(at(mesh.joints()));
  std::iota(joints.begin(), joints.end(), 0);
  const JointFinder finder(mesh, joints, 0.5);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> x(-2.2, 4.2);
  std::uniform_real_distribution<double> y(0.8, 1.7);
  for (int i = 0; i < 500; ++i) {
    const Point p{x(random), y(random)};
    const auto near = finder.near(p);
    std::size_t close = 0;
    for (const Index j : joints) {
      const std::vector<Index> one{j};
      close += nearest_joint(mesh, one, p)->distance <= 0.5 * mesh.joint_length(j) ? 1U : 0U;
    }
    EXPECT_EQ(near.size(), close);
    if (close > 0) {
      const auto nearest = nearest_joint(mesh, joints, p);
      EXPECT_LE(nearest->distance, near.front().distance);
    }
  }
}

}  // namespace
}  // namespace percolith::mesh
