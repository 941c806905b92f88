// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "unit/mechanics/test_contact_support.hpp"

namespace percolith::mechanics {
namespace {

using test::at;

/// A bonded block with its free boundary, whose joints break one after the other while it moves.
struct Breaking {
  test::Bodies bodies{percolith::test::make_grid({.columns = 8, .rows = 8, .jitter = 0.2}), {}, 1};
  std::mt19937 random{5};
  std::vector<Index> order = std::vector<Index>(bodies.mesh().joint.size());

  Breaking() {
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    for (std::size_t t = 0; t < bodies.candidate().size(); ++t) {
      bodies.candidate()[t] = 0;
    }
    for (const mesh::BoundaryEdge& edge : bodies.mesh().boundary) {
      mark(edge.vertex);
    }
    bodies.refresh();
    bodies.advance();
  }
  void mark(const std::array<Index, 2>& ends) {
    for (const Index v : ends) {
      for (const Index corner : bodies.mesh().vertex_corners.row(v)) {
        bodies.candidate()[at(mesh::triangle_of(corner))] = 1;
      }
    }
  }
  void break_joint(Index j) {
    bodies.tied()[at(j)] = 0;
    bodies.touch()[at(j)] = 1;
    mark(bodies.mesh().joint[at(j)].vertex);
  }
  /// Moves all triangles and advances; what changed may be told or searched for.
  void step(std::span<const Index> told) {
    std::uniform_real_distribution<double> shift(-1e-4, 1e-4);
    for (Index t = 0; t < bodies.mesh().triangles(); ++t) {
      bodies.move(t, {shift(random), shift(random)});
      bodies.set_velocity(t, {shift(random), shift(random)});
    }
    bodies.refresh(told);
    bodies.advance(1.5e-4, 1.0);
  }
};

TEST(ContactBreaking, AddingPairsGivesTheForcesOfASearch) {
  Breaking added;
  Breaking searched;
  const std::vector<Index> order = added.order;
  std::size_t next = 0;
  double largest = 0.0;
  for (int i = 0; i < 60; ++i) {
    std::vector<Index> broken;
    for (int k = 0; k < i % 4 + 1 && next < order.size(); ++k) {
      broken.push_back(order[next++]);
    }
    for (const Index j : broken) {
      added.break_joint(j);
      searched.break_joint(j);
    }
    added.step(broken);
    searched.step({});
    for (const Index t : {0, 17, 60, 127}) {
      for (Index k = 0; k < 3; ++k) {
        EXPECT_EQ(added.bodies.corner_force(t, k), searched.bodies.corner_force(t, k)) << i;
      }
      const Point force = added.bodies.force(t);
      largest = std::max(largest, std::abs(force.x) + std::abs(force.y));
    }
    EXPECT_EQ(added.bodies.contact().touching_pairs(), searched.bodies.contact().touching_pairs());
  }
  EXPECT_GT(largest, 0.0);
  EXPECT_GT(added.bodies.contact().touching_pairs(), 50);
  EXPECT_GE(added.bodies.contact().listed_pairs(), searched.bodies.contact().listed_pairs());
  EXPECT_NEAR(added.bodies.contact().friction_dissipation(),
              searched.bodies.contact().friction_dissipation(),
              1e-12 * searched.bodies.contact().friction_dissipation());
}

TEST(ContactBreaking, TheFirstTrianglesThatMayTouchMayComeWithAJoint) {
  test::Bodies bodies(percolith::test::make_grid({.columns = 3, .rows = 3}), {}, 1);
  bodies.candidate().assign(bodies.candidate().size(), 0);
  bodies.refresh();
  bodies.advance();
  EXPECT_EQ(bodies.contact().listed_pairs(), 0);
  const Index j =
      percolith::test::joint_between(bodies.mesh(), {1.0 / 3, 1.0 / 3}, {2.0 / 3, 1.0 / 3});
  bodies.tied()[at(j)] = 0;
  bodies.touch()[at(j)] = 1;
  const auto& sides = bodies.mesh().joint[at(j)].corner;
  for (const auto& side : sides) {
    bodies.candidate()[at(mesh::triangle_of(side[0]))] = 1;
  }
  bodies.refresh(std::array{j});
  bodies.advance(1e-9);
  EXPECT_EQ(bodies.contact().listed_pairs(), 1);
}

TEST(ContactBreaking, AJointHandsItsForceToAPairThatIsAdded) {
  test::Bodies bodies(percolith::test::make_grid({.columns = 1, .rows = 1}), {}, 1);
  bodies.advance();
  bodies.move(1, {1e-3, -1e-3});
  bodies.tied()[0] = 0;
  bodies.touch()[0] = 1;
  bodies.refresh(std::array<Index, 1>{0});
  const double force = 1e6;
  bodies.contact().hand_over(bodies.mesh(), {0, force, {}});
  bodies.advance(2e-3);
  EXPECT_NEAR(std::hypot(bodies.force(1).x, bodies.force(1).y), force, 1e-9 * force);
}

TEST(ContactBreaking, PairsThatRestedWhileApartAreAwakeWhenTheyMeet) {
  const double height = 0.05;
  test::Bodies resting = test::Bodies::of({test::floor_triangle, test::pointed});
  resting.move(1, {0.0, height});
  resting.advance();
  ASSERT_EQ(resting.contact().listed_pairs(), 1);
  test::Bodies searching = test::Bodies::of({test::floor_triangle, test::pointed});
  searching.move(1, {0.0, height});
  searching.advance();
  const double down = 1e-3;
  int touched = 0;
  for (int i = 0; i < 60; ++i) {
    resting.move(1, {0.0, -down});
    searching.move(1, {0.0, -down});
    resting.advance(down);
    searching.refresh();
    searching.advance(10.0);
    EXPECT_EQ(resting.force(1), searching.force(1)) << i;
    touched += resting.force(1).y > 0.0 ? 1 : 0;
  }
  EXPECT_GE(touched, 9);
}

}  // namespace
}  // namespace percolith::mechanics
