// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "unit/support/coupled_model.hpp"

namespace percolith::coupling {
namespace {

using test::at;
using test::Coupled;
using test::CoupledOptions;

constexpr test::Grid grid{.columns = 6, .rows = 6, .jitter = 0.15, .mixed_diagonals = true};

/// Water pressed into the crack until the rock breaks, through which it leaks.
CoupledOptions injected(PoreFlow pore_flow, double exchange = 1e-8) {
  CoupledOptions options;
  options.pore_flow = pore_flow;
  options.solid.kind = test::joint_kind(2e6, 6e6, 20.0, 60.0);
  options.solid.damping.local = 0.1;
  options.solid.curves = {{"crack", mechanics::JointState::closed}};
  options.flow.rock.permeability = {1e-12, 1e-12, 0.0};
  options.flow.rock.biot_modulus = 10e9;
  options.flow.fracture[0].maximum_aperture = 2e-4;
  options.flow.fracture[0].exchange = exchange;
  options.prepare_water = [](seepage::Model& water) {
    test::break_curve(water, "crack");
    seepage::set_cracks(water, [](const Point&) { return seepage::FluidState<double>{0.0, 1.0}; });
    test::inject_crack(water, "source.left", Schedule::constant(0.1), {0.0, 0.5});
  };
  return options;
}

double crack_fluid(const seepage::Model& water) {
  double sum = 0.0;
  for (const Index v : water.cracks.open_nodes()) {
    sum += water.crack.void_volume[at(v)] + water.state.crack_content[at(v)];
  }
  return sum;
}

/// Largest difference of the pressures in pores and cracks over the largest of them.
double difference(const seepage::Model& a, const seepage::Model& b) {
  double most = 0.0;
  double largest = 0.0;
  const auto compare = [&](const std::vector<double>& p, const std::vector<double>& q) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      most = std::max(most, std::abs(p[i] - q[i]));
      largest = std::max(largest, std::abs(p[i]));
    }
  };
  compare(a.state.pressure, b.state.pressure);
  compare(a.state.crack_pressure, b.state.crack_pressure);
  return most / largest;
}

/// By how much both ways differ once the first joint has broken and some time after, with steps of
/// a share of the longest.
double difference_after_breakage(double share) {
  Coupled one(test::notched(grid), injected(PoreFlow::explicit_));
  Coupled other(test::notched(grid), injected(PoreFlow::implicit));
  const double longest = 0.5 * one.limit().motion(one.model());
  Execution execution;
  int broke = 0;
  while (one.water().state.time < 0.9e-3) {
    broke += static_cast<int>(one.step().advance(share * longest, execution).broke.size());
    other.step().advance(share * longest, execution);
  }
  EXPECT_GT(broke, 0);
  EXPECT_EQ(one.water().cracks.broken_joints(), other.water().cracks.broken_joints());
  EXPECT_NEAR(one.step().leaked(), other.step().leaked(), 0.05 * one.step().leaked());
  return difference(one.water(), other.water());
}

TEST(ImplicitPores, AreThoseOfSmallExplicitSteps) {
  const double coarse = difference_after_breakage(1.0);
  const double fine = difference_after_breakage(0.25);
  EXPECT_LT(coarse, 1e-2);
  EXPECT_LT(fine, 0.4 * coarse);
}

struct Walls {
  double exchange;
  seepage::PoreJoints pore_joints;
  FluidEnters fluid_enters;
};

class Breakage : public testing::TestWithParam<Walls> {};

TEST_P(Breakage, LosesNeitherFluidNorEnergy) {
  CoupledOptions options = injected(PoreFlow::implicit, GetParam().exchange);
  options.flow.joints = GetParam().pore_joints;
  options.fluid_enters = GetParam().fluid_enters;
  Coupled coupled(test::notched(grid), options);
  const double held = crack_fluid(coupled.water());
  EXPECT_GT(coupled.advance(800), 0);
  EXPECT_GT(coupled.water().cracks.broken_joints().size(), 3U);
  EXPECT_GT(coupled.rock().energy(Execution()).fluid, 1.0);
  EXPECT_LT(coupled.mass_error(), 1e-13);
  EXPECT_LT(coupled.energy_error(), 1e-2);
  // What was pumped into the cracks is there or has leaked.
  const double pumped = coupled.water().let_in[0].total();
  EXPECT_GT(std::abs(coupled.step().leaked()), 1e-3 * pumped);
  EXPECT_NEAR(crack_fluid(coupled.water()) - held, pumped - coupled.step().leaked(),
              1e-12 * pumped);
}

INSTANTIATE_TEST_SUITE_P(
    OfWalls, Breakage,
    testing::Values(Walls{1e-8, seepage::PoreJoints::tied, FluidEnters::broken},
                    Walls{1e-8, seepage::PoreJoints::finite, FluidEnters::softening},
                    Walls{test::infinity, seepage::PoreJoints::tied, FluidEnters::broken},
                    Walls{test::infinity, seepage::PoreJoints::finite, FluidEnters::broken}));

/// Faces that have just come about share the pressure of their crack as those from the start do.
TEST(ImplicitPores, GiveNewCracksAndTheirFacesOnePressure) {
  Coupled coupled(test::notched(grid), injected(PoreFlow::implicit, test::infinity));
  const seepage::Model& water = coupled.water();
  double largest = 0.0;
  int broke = 0;
  for (int i = 0; i < 10; ++i) {
    broke += coupled.advance(100);
    for (const Index j : water.cracks.broken_joints()) {
      const mesh::Joint& joint = water.mesh.joint[at(j)];
      for (std::size_t end = 0; end < 2; ++end) {
        const auto crack = at(joint.vertex[end]);
        largest = std::max(largest, water.state.crack_pressure[crack]);
        for (const auto& side : joint.corner) {
          ASSERT_NEAR(water.state.pressure[at(side[end])], water.state.crack_pressure[crack], 0.1);
          ASSERT_NEAR(water.state.saturation[at(side[end])], water.state.crack_saturation[crack],
                      1e-9);
        }
      }
    }
  }
  EXPECT_GT(broke, 0);
  EXPECT_GT(largest, 1e5);
}

/// Pressures are those of a large coefficient, also once rock has broken; so is what leaks as long
/// as nothing is partly empty, where one pressure means one saturation too.
TEST(ImplicitPores, InfiniteExchangeIsTheLimitOfALargeOne) {
  Coupled tied(test::notched(grid), injected(PoreFlow::implicit, test::infinity));
  Coupled large(test::notched(grid), injected(PoreFlow::implicit, 1e-3));
  const double dt = 0.5 * tied.limit().motion(tied.model());
  Execution execution;
  const auto advance = [&](int steps) {
    for (int i = 0; i < steps; ++i) {
      tied.step().advance(dt, execution);
      large.step().advance(dt, execution);
    }
  };
  advance(60);
  ASSERT_EQ(test::saturation_range(tied.water()).first, 1.0);
  EXPECT_LT(difference(tied.water(), large.water()), 1e-3);
  EXPECT_NEAR(tied.step().leaked(), large.step().leaked(), 1e-3 * large.step().leaked());
  advance(400);
  EXPECT_GT(tied.water().cracks.broken_joints().size(), 3U);
  EXPECT_LT(difference(tied.water(), large.water()), 1e-3);
}

TEST(ImplicitPores, GiveTheSameBitsOnAnyNumberOfThreads) {
  std::string reference;
  for (const auto& [backend, threads] :
       {std::pair{Backend::serial, 1}, {Backend::host, 1}, {Backend::host, 2}}) {
    Coupled coupled(test::notched(grid), injected(PoreFlow::implicit));
    Execution execution(backend, threads);
    EXPECT_GT(coupled.advance(600, execution), 0);
    if (reference.empty()) {
      reference = coupled.bits();
    }
    EXPECT_EQ(coupled.bits(), reference) << threads;
  }
}

/// Rock that lets fluid through far faster than it moves gives its explicit limit no say: squeezed
/// between closed sides it has one pressure, the undrained one.
TEST(ImplicitPores, FollowPressuresThatLevelOutWithinAStep) {
  CoupledOptions options = test::squeezed();
  options.pore_flow = PoreFlow::implicit;
  options.flow.rock.permeability = {1e-7, 1e-7, 0.0};
  Coupled coupled(test::make_grid(grid), options);
  ASSERT_LT(coupled.limit().pores(), 1e-3 * coupled.limit().rock());
  coupled.advance(2000);
  for (const Index node : coupled.water().pore_nodes.nodes(coupled.water().mesh)) {
    EXPECT_NEAR(coupled.water().state.pressure[at(node)], test::squeezed_pressure,
                1e-3 * test::squeezed_pressure);
  }
  EXPECT_LT(coupled.mass_error(), 1e-14);
}

}  // namespace
}  // namespace percolith::coupling
