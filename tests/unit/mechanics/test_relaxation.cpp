// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/joint_points.hpp"
#include "percolith/mechanics/relaxation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <utility>

#include "unit/support/solid_model.hpp"

namespace percolith::mechanics {
namespace {

using test::at;

const test::Grid grid{.columns = 4, .rows = 4, .jitter = 0.2, .seed = 3, .mixed_diagonals = true};

SupportSet held_below(Model& model) {
  std::vector<Held> held;
  const auto below = [](Point p) { return p.y == 0.0; };
  test::hold_where(model, below, {1.0, 0.0}, 0, held);
  test::hold_where(model, below, {0.0, 1.0}, 0, held);
  return {model, {{"below", PrescribedMotion::Kind::velocity, Schedule{}}}, held};
}

/// A block held below and pushed aside above.
Dynamics pushed(const test::SolidOptions& options = {}, double traction = 1e5) {
  Model model = test::make_solid(test::make_grid(grid), options);
  LoadList loads;
  loads.traction.push_back(
      {test::edges_of(model, "top"), Schedule::constant(traction), Schedule{}});
  SupportSet supports = held_below(model);
  return test::make_dynamics(std::move(model), std::move(loads), std::move(supports));
}

/// Evaluations of the forces until they are balanced to `tolerance` of the internal ones.
int pull_to_rest(Dynamics& rock, double tolerance = 1e-9) {
  Relaxation relaxation(rock);
  Execution execution;
  relaxation.begin(execution);
  for (int step = 1; step <= 2000; ++step) {
    relaxation.pull(execution);
    if (rock.unbalanced_ratio() < tolerance) {
      relaxation.end(execution);
      return step;
    }
  }
  return -1;
}

/// Where damped motion comes to rest, the other way to look for it.
Point place_of_damped_motion(Point place, const test::SolidOptions& options) {
  test::SolidOptions damped = options;
  damped.damping.local = 0.7;
  Dynamics rock = pushed(damped);
  test::advance(rock, 0.9 * test::stable_step(rock), 8000);
  EXPECT_LT(rock.unbalanced_ratio(), 1e-5);
  return test::displacement_at(rock.model(), place);
}

TEST(Relaxation, FindsTheRestThatDampedMotionFindsInFarFewerSteps) {
  for (const JointState joints : {JointState::bonded, JointState::tied}) {
    test::SolidOptions options;
    options.joints = joints;
    Dynamics rock = pushed(options);
    const int steps = pull_to_rest(rock);
    EXPECT_GT(steps, 0);
    EXPECT_LT(steps, 300);
    const Point sought = place_of_damped_motion({1.0, 1.0}, options);
    const Point found = test::displacement_at(rock.model(), {1.0, 1.0});
    EXPECT_GT(sought.x, 1e-6);
    EXPECT_NEAR(found.x, sought.x, 1e-4 * sought.x);
    EXPECT_NEAR(found.y, sought.y, 1e-4 * sought.x);
  }
}

/// The same number of steps for a mesh twice as fine: modes of all lengths decay alike.
TEST(Relaxation, TakesNoMoreStepsOnAFinerMesh) {
  const auto steps_on = [](int cells) {
    const test::Grid fine{.columns = cells, .rows = cells, .jitter = 0.2, .mixed_diagonals = true};
    Model model = test::make_solid(test::make_grid(fine));
    LoadList loads;
    loads.traction.push_back({test::edges_of(model, "top"), Schedule::constant(1e5), Schedule{}});
    SupportSet supports = held_below(model);
    Dynamics rock = test::make_dynamics(std::move(model), std::move(loads), std::move(supports));
    return pull_to_rest(rock, 1e-7);
  };
  const int coarse = steps_on(8);
  EXPECT_GT(coarse, 0);
  EXPECT_LT(steps_on(24), 1.5 * coarse);
}

/// Dead loads do f u of work on the way from rest to rest, of which elastic rock keeps half and the
/// medium it is dragged through takes the rest.
TEST(Relaxation, BooksTheWorksOfItsWays) {
  for (const JointState joints : {JointState::bonded, JointState::tied}) {
    test::SolidOptions options;
    options.joints = joints;
    Dynamics rock = pushed(options, 1e4);
    ASSERT_GT(pull_to_rest(rock, 1e-10), 0);
    const EnergyBalance energy = rock.energy(Execution());
    EXPECT_EQ(energy.kinetic, 0.0);
    EXPECT_GT(energy.external, 0.0);
    EXPECT_NEAR(energy.elastic + energy.joint, 0.5 * energy.external, 1e-3 * energy.external);
    EXPECT_NEAR(energy.damping, 0.5 * energy.external, 1e-3 * energy.external);
    EXPECT_LT(std::abs(energy.residual), 1e-3 * energy.external);
  }
}

/// Breakage ends a relaxation in mid-way: what was done up to there is in the books all the same.
TEST(Relaxation, BooksTheWorksOfWaysThatEndShortOfRest) {
  const auto missed = [](int steps, auto&& step) {
    Dynamics rock = pushed();
    Relaxation relaxation(rock);
    Execution execution;
    relaxation.begin(execution);
    for (int n = 0; n < steps; ++n) {
      step(relaxation, execution);
    }
    EXPECT_GT(rock.unbalanced_ratio(), 0.01);
    relaxation.end(execution);
    const EnergyBalance energy = rock.energy(execution);
    EXPECT_GT(energy.elastic + energy.joint, 0.01 * energy.external);
    return std::abs(energy.residual) / energy.external;
  };
  for (const int steps : {3, 5, 10, 25}) {
    const double swinging = missed(steps, [](Relaxation& r, Execution& e) { r.swing(e); });
    const double pulling = missed(steps, [](Relaxation& r, Execution& e) { r.pull(e); });
    EXPECT_LT(swinging, 5e-3) << steps;
    EXPECT_LT(pulling, 5e-3) << steps;
  }
}

/// Nothing holds the block, so it has no place of its own: it keeps its middle.
TEST(Relaxation, ALooseBlockStaysWhereItIs) {
  Model model = test::make_solid(test::make_grid(grid));
  LoadList loads;
  std::vector<Index> edges(model.mesh.boundary.size());
  std::iota(edges.begin(), edges.end(), 0);
  loads.pressure.push_back({edges, Schedule::constant(1e6)});
  Dynamics rock = test::make_dynamics(std::move(model), std::move(loads));
  // Pressure turns with faces that joints leave ajar, so that its sum is not zero to the last
  // digit.
  ASSERT_GT(pull_to_rest(rock, 1e-6), 0);
  Point mean{};
  test::for_each_corner(rock.model().mesh,
                        [&](Index, Index c) { mean = mean + test::displacement(rock.model(), c); });
  const double size = std::abs(test::displacement_at(rock.model(), {1.0, 1.0}).x);
  EXPECT_GT(size, 1e-6);
  EXPECT_LT(std::abs(mean.x) / rock.model().mesh.corners(), 1e-2 * size);
}

TEST(JoinedRock, GoesWhereTiedRockIsInBalanceAtOnce) {
  Dynamics rock = pushed({.joints = JointState::tied}, 1e3);
  Execution execution;
  const double step = 1e-7;
  rock.pull(step, execution);
  const double before = rock.model().energy.unbalanced;
  EXPECT_GT(before, 100.0);
  std::vector<double> pull(2 * rock.model().motion.ux.size(), 0.0);
  test::for_each_corner(rock.model().mesh, [&](Index t, Index c) {
    const double force = 1.0 / (rock.model().triangles.inverse_mass[at(t)] * step);
    pull[2 * at(c)] = force * rock.model().motion.vx[at(c)];
    pull[2 * at(c) + 1] = force * rock.model().motion.vy[at(c)];
  });
  std::vector<double> way(pull.size());
  JoinedRock joined(rock.model());
  joined.refresh(rock.model());
  joined.find_way(rock.model(), pull, way);
  rock.shift(way, step, execution);
  rock.pull(step, execution);
  // Strains are small but not infinitely so.
  EXPECT_LT(rock.model().energy.unbalanced, 1e-4 * before);
}

/// A joint of two triangles whose broken faces have gone apart by a tenth of a millimetre on one
/// end and three on the other, as a way brings them together on the first, or further apart.
TEST(JoinedRock, StopsWhereOpenFacesMeet) {
  const double gap = 1e-4;
  Model model = test::make_solid(test::make_grid({.columns = 1, .rows = 1}),
                                 {.kind = test::joint_kind(1e6, 3e6, 100.0, 200.0)});
  const Index j = 0;
  const mesh::Joint& joint = model.mesh.joint[at(j)];
  const Point across = joint_openings(model, j).place.across;
  model.joints.state[at(j)] = JointState::broken;
  for (std::size_t end = 0; end < 2; ++end) {
    const auto c = at(joint.corner[1][end]);
    model.motion.ux[c] = (end == 0 ? gap : 3.0 * gap) * across.x;
    model.motion.uy[c] = (end == 0 ? gap : 3.0 * gap) * across.y;
  }
  JoinedRock joined(model);
  joined.refresh(model);
  std::vector<double> way(2 * model.motion.ux.size(), 0.0);
  const auto go = [&](double length) {
    const auto c = at(joint.corner[1][0]);
    way[2 * c] = length * across.x;
    way[2 * c + 1] = length * across.y;
  };
  go(-5.0 * gap);
  EXPECT_NEAR(joined.share_to_meeting(model, way, 0.0), 0.2, 1e-3);
  const double give = 0.5 * gap;
  const double force = give * model.joints.full_stiffness[at(j)] * model.joints.length[at(j)];
  EXPECT_NEAR(joined.share_to_meeting(model, way, force), 0.3, 1e-3);
  go(-0.9 * gap);
  EXPECT_EQ(joined.share_to_meeting(model, way, 0.0), 1.0);
  go(5.0 * gap);
  EXPECT_EQ(joined.share_to_meeting(model, way, 0.0), 1.0);
}

/// Where bonds have softened their secant holds, at least a fiftieth of what it was.
TEST(SoftJoints, HoldBySecants) {
  Model model = test::make_solid(test::make_grid({.columns = 1, .rows = 1}),
                                 {.kind = test::joint_kind(1e6, 3e6, 100.0, 200.0)});
  const JointTable table = joint_table(model);
  EXPECT_TRUE(soft_joints(model, table).empty());
  const Index j = 0;
  EXPECT_TRUE(is_whole(model, j));
  // Side 1 goes away across the joint, to half of the range of softening.
  const mesh::Joint& joint = model.mesh.joint[at(j)];
  const Point across = joint_openings(model, j).place.across;
  const double opening = 0.5 / table[0].opening_range;
  for (const Index c : joint.corner[1]) {
    model.motion.ux[at(c)] = opening * across.x;
    model.motion.uy[at(c)] = opening * across.y;
  }
  test::joint_forces_of(model);
  EXPECT_FALSE(is_whole(model, j));
  const std::vector<SoftJoint> soft = soft_joints(model, table);
  ASSERT_EQ(soft.size(), 1U);
  const double full = model.joints.full_stiffness[at(j)];
  const double traction = joint_points(model, table, j).traction[0].normal;
  EXPECT_GT(traction, 1e4);
  EXPECT_NEAR(soft[0].normal[0], std::max(0.02 * full, traction / opening), 1e-9 * full);
  EXPECT_EQ(soft[0].shear[0], full);
  EXPECT_TRUE(about_the_same(soft, soft));
  EXPECT_FALSE(about_the_same(soft, {}));
}

}  // namespace
}  // namespace percolith::mechanics
