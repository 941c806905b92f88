// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/hash.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "unit/support/flow_model.hpp"

namespace percolith::seepage {
namespace {

using test::at;

/// An irregular model with a random state, full and partly empty nodes mixed.
Model random_model(PoreJoints joints) {
  test::FlowOptions options;
  options.joints = joints;
  Model model = test::make_flow(
      test::make_grid({.columns = 9, .rows = 8, .jitter = 0.3, .mixed_diagonals = true}), options);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  set_pores(model, [&](const Point&) {
    return unit(random) < 0.5 ? FluidState<double>{1e6 * unit(random), 1.0}
                              : FluidState<double>{0.0, unit(random)};
  });
  return model;
}

std::vector<Index> half_of_the_joints(const Model& model, unsigned seed) {
  std::vector<Index> joints;
  for (Index j = 0; j < model.mesh.joints(); j += 2) {
    joints.push_back(j);
  }
  std::shuffle(joints.begin(), joints.end(), std::mt19937(seed));
  return joints;
}

std::string bits_of(const Model& model) {
  StateHash hash;
  const State& s = model.state;
  for (const auto* field :
       {&s.pressure, &s.saturation, &s.content, &s.content_carry, &s.storage, &s.void_volume,
        &s.crack_pressure, &s.crack_saturation, &s.crack_content, &s.crack_content_carry,
        &model.crack.void_volume, &model.crack.conductance}) {
    hash.add(*field);
  }
  return hash.text();
}

class BreakJoints : public testing::TestWithParam<PoreJoints> {};

TEST_P(BreakJoints, InOneBatchOfAnyOrderGivesTheSameBits) {
  Model reference = random_model(GetParam());
  break_joints(reference, half_of_the_joints(reference, 1), 0);
  for (const unsigned seed : {2u, 3u}) {
    Model model = random_model(GetParam());
    break_joints(model, half_of_the_joints(model, seed), 0);
    EXPECT_EQ(bits_of(model), bits_of(reference));
    EXPECT_EQ(model.tied, reference.tied);
  }
}

TEST_P(BreakJoints, OneByOneGivesTheSameTopologyAndContents) {
  Model reference = random_model(GetParam());
  break_joints(reference, half_of_the_joints(reference, 1), 0);
  for (const unsigned seed : {2u, 3u}) {
    Model model = random_model(GetParam());
    for (const Index j : half_of_the_joints(model, seed)) {
      break_joints(model, std::span<const Index>(&j, 1), 0);
    }
    EXPECT_TRUE(std::ranges::equal(model.pore_nodes.leaders(), reference.pore_nodes.leaders()));
    EXPECT_EQ(model.cracks.open_nodes(), reference.cracks.open_nodes());
    EXPECT_EQ(model.cracks.broken_joints(), reference.cracks.broken_joints());
    EXPECT_EQ(model.crack.void_volume, reference.crack.void_volume);
    for (const Index node : reference.pore_nodes.nodes(reference.mesh)) {
      EXPECT_EQ(model.state.storage[at(node)], reference.state.storage[at(node)]);
      EXPECT_NEAR(model.state.content[at(node)], reference.state.content[at(node)],
                  1e-15 * std::abs(reference.state.content[at(node)]));
      EXPECT_EQ(model.state.pressure[at(node)], reference.state.pressure[at(node)]);
      EXPECT_EQ(model.state.saturation[at(node)], reference.state.saturation[at(node)]);
    }
    for (const Index v : reference.cracks.open_nodes()) {
      EXPECT_NEAR(model.state.crack_content[at(v)], reference.state.crack_content[at(v)],
                  1e-15 * std::abs(reference.state.crack_content[at(v)]));
    }
  }
}

TEST_P(BreakJoints, KeepsTheFluidAndThePoreStateAndOpensEmptyCracks) {
  Model model = random_model(GetParam());
  const auto pressure = model.state.pressure;
  const auto saturation = model.state.saturation;
  const test::Balance balance(model);
  break_joints(model, half_of_the_joints(model, 1), 0);
  EXPECT_LT(balance.error(model), 1e-15);
  EXPECT_EQ(model.state.pressure, pressure);
  EXPECT_EQ(model.state.saturation, saturation);
  for (const Index v : model.cracks.open_nodes()) {
    EXPECT_EQ(model.state.crack_pressure[at(v)], 0.0);
    EXPECT_NEAR(model.state.crack_saturation[at(v)], 0.0, 1e-15);
  }
  // Contents still say what pressures and saturations say.
  for (const Index node : model.pore_nodes.nodes(model.mesh)) {
    const auto i = at(node);
    const auto fluid = fluid_state(model.state.content[i], 0.0, model.state.storage[i],
                                   model.state.void_volume[i], 0.0, true);
    EXPECT_NEAR(fluid.pressure, model.state.pressure[i], 1e-9);
    EXPECT_NEAR(fluid.saturation, model.state.saturation[i], 1e-15);
  }
}

INSTANTIATE_TEST_SUITE_P(PoreJoints, BreakJoints,
                         testing::Values(PoreJoints::tied, PoreJoints::finite));

TEST(BreakJoints, ASealedFullCrackThatGrowsFallsInSaturation) {
  const test::Grid grid{.columns = 4, .rows = 4};
  auto file = test::make_grid(grid);
  test::add_column_curve(grid, file, "old", 2, 1, 2);
  test::add_column_curve(grid, file, "new", 2, 2, 3);
  Model model = test::make_flow(file, {});
  test::break_curve(model, "old");
  set_cracks(model, [](const Point&) { return FluidState<double>{2e6, 1.0}; });
  const test::Balance balance(model);
  test::break_curve(model, "new");
  const auto middle = at(test::vertex_at(model.mesh, {0.5, 0.5}));
  const auto lower = at(test::vertex_at(model.mesh, {0.5, 0.25}));
  const auto upper = at(test::vertex_at(model.mesh, {0.5, 0.75}));
  // Half of the volume in the middle is new: s = (1 + p/K_w)/2.
  EXPECT_NEAR(model.state.crack_saturation[middle], 0.5 * (1.0 + 2e6 / 2.2e9), 1e-14);
  EXPECT_EQ(model.state.crack_pressure[middle], 0.0);
  EXPECT_EQ(model.state.crack_saturation[lower], 1.0);
  EXPECT_NEAR(model.state.crack_pressure[lower], 2e6, 1e-3);
  EXPECT_EQ(model.state.crack_saturation[upper], 0.0);
  EXPECT_LT(balance.error(model), 1e-15);
}

TEST(BreakJoints, ASecondTimeChangesNothing) {
  Model model = random_model(PoreJoints::tied);
  const auto joints = half_of_the_joints(model, 1);
  break_joints(model, joints, 0);
  const auto before = bits_of(model);
  break_joints(model, joints, 0);
  EXPECT_EQ(bits_of(model), before);
}

}  // namespace
}  // namespace percolith::seepage
