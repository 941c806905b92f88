// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/error.hpp"
#include "percolith/coupling/pressure_rise.hpp"
#include "percolith/coupling/quasi_static.hpp"

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

/// Holds the lower and the upper side, or all of them.
mechanics::SupportSet held(mechanics::Model& rock, bool all = false) {
  std::vector<mechanics::Held> corners;
  for (const mesh::BoundaryEdge& edge : rock.mesh.boundary) {
    const Point a = rock.mesh.vertex[at(edge.vertex[0])];
    const Point b = rock.mesh.vertex[at(edge.vertex[1])];
    if (all || a.y == b.y) {
      for (const Index corner : edge.corner) {
        corners.push_back({corner, {1.0, 0.0}, 0});
        corners.push_back({corner, {0.0, 1.0}, 0});
      }
    }
  }
  return {rock, {{"held", mechanics::PrescribedMotion::Kind::velocity, Schedule{}}}, corners};
}

/// A little water an hour into a crack with sealed faces.
CoupledOptions pumped(const mechanics::JointKind& kind, double rate = 1e-9) {
  CoupledOptions options;
  options.solid.kind = kind;
  options.solid.damping.local = 0.7;
  options.solid.curves = {{"crack", mechanics::JointState::closed}};
  options.supports = [](mechanics::Model& rock) { return held(rock); };
  options.flow.rock.permeability = {1e-20, 1e-20, 0.0};
  options.flow.rock.biot_modulus = 10e9;
  options.flow.fracture[0].exchange = 0.0;
  options.prepare_water = [rate](seepage::Model& water) {
    test::break_curve(water, "crack");
    seepage::set_cracks(water, [](const Point&) { return seepage::FluidState<double>{0.0, 1.0}; });
    test::inject_crack(water, "source.pump", Schedule::constant(rate), {0.0, 0.5});
  };
  return options;
}

QuasiStaticOptions exact() {
  return {1e-3, 1e-4};
}

/// What the cracks hold, m2.
double fluid_in_cracks(const seepage::Model& water) {
  double sum = 0.0;
  for (const Index v : water.cracks.open_nodes()) {
    sum += water.crack.void_volume[at(v)] + water.state.crack_content[at(v)];
  }
  return sum;
}

/// What they hold when full at the pressures they show, V (1 + p/K), m2.
double full_cracks(const seepage::Model& water) {
  double sum = 0.0;
  for (const Index v : water.cracks.open_nodes()) {
    sum += water.crack.void_volume[at(v)] *
           (1.0 + water.state.crack_pressure[at(v)] / water.fluid.bulk_modulus);
  }
  return sum;
}

/// Fluid and room agree at the pressure that was found, which the contents do not show: V (1 + p/K)
/// is what the crack holds.
TEST(QuasiStatic, FindsThePressureThatHoldsTheCrackOpen) {
  Coupled coupled(test::notched(grid), pumped(test::strong()));
  QuasiStatic scheme(coupled.model(), exact());
  Execution execution;
  for (int hour = 0; hour < 2; ++hour) {
    scheme.advance(3600.0, execution);
  }
  const seepage::Model& water = coupled.water();
  EXPECT_DOUBLE_EQ(water.state.time, 2 * 3600.0);
  EXPECT_DOUBLE_EQ(coupled.rock().model().motion.time, 2 * 3600.0);
  EXPECT_LT(coupled.mass_error(), 1e-14);
  EXPECT_LT(coupled.rock().unbalanced_ratio(), 1e-3);
  double held = 0.0;
  double room = 0.0;
  double pressure = 0.0;
  for (const Index v : water.cracks.open_nodes()) {
    held += water.state.crack_content[at(v)];
    room += water.crack.void_volume[at(v)];
    pressure = std::max(pressure, water.state.crack_pressure[at(v)]);
    EXPECT_GT(water.state.crack_pressure[at(v)], 0.0);
  }
  EXPECT_GT(pressure, 1e5);
  // The error of the room is that of the pressure over the stiffness of the rock.
  EXPECT_NEAR(held, room * pressure / water.fluid.bulk_modulus, 1e-2 * 2 * 3600.0 * 1e-9);
}

/// Water that comes into a crack brings the pressure it had elsewhere: no rise, up to the highest.
TEST(PressureRise, OfCracksThatFillIsWhatComesOnTopOfTheHighest) {
  Coupled coupled(test::notched(grid), pumped(test::strong()));
  seepage::Model& water = coupled.water();
  const auto& open = water.cracks.open_nodes();
  ASSERT_GT(open.size(), 1U);
  for (const Index v : open) {
    water.state.crack_pressure[at(v)] = 1e6;
  }
  const Index filling = open.front();
  water.state.crack_pressure[at(filling)] = 0.0;
  water.state.crack_saturation[at(filling)] = 0.5;
  PressureRise rise(water);
  water.state.crack_pressure[at(filling)] = 1e6;
  rise.see(water);
  EXPECT_EQ(rise.largest(), 0.0);
  water.state.crack_pressure[at(filling)] = 1.25e6;
  rise.see(water);
  EXPECT_DOUBLE_EQ(rise.largest(), 0.2);
  water.state.crack_pressure[at(open.back())] = 2e6;
  rise.see(water);
  EXPECT_DOUBLE_EQ(rise.largest(), 0.5);
}

/// Water into a notch of a tough block held on all sides, in which cracks do not break through.
CoupledOptions confined() {
  CoupledOptions options = pumped(test::joint_kind(1e6, 10e6, 20.0, 200.0), 1e-7);
  options.supports = [](mechanics::Model& rock) { return held(rock, true); };
  return options;
}

/// An hour of it in steps of `dt` seconds. What breaks in parts that are given up does not count,
/// and what does has a time within its step.
std::size_t broken_after_an_hour(double dt) {
  Coupled coupled(test::notched(grid), confined());
  QuasiStatic scheme(coupled.model(), {1e-2, 1e-3});
  Execution execution;
  std::size_t broke = 0;
  for (double t = 0.0; t < 3600.0; t += dt) {
    const auto changes = scheme.advance(dt, execution);
    broke += changes.broke.size();
    for (const mechanics::Breakage& breakage : changes.broke) {
      EXPECT_GT(breakage.time, t);
      EXPECT_LE(breakage.time, t + dt);
    }
  }
  EXPECT_EQ(coupled.water().cracks.broken_joints().size(), 3U + broke);
  EXPECT_LT(coupled.mass_error(), 1e-13);
  // It has found the room that the fluid needs, which an iteration that creeps has not.
  EXPECT_NEAR(fluid_in_cracks(coupled.water()) / full_cracks(coupled.water()), 1.0, 3e-2);
  const mechanics::EnergyBalance energy = coupled.rock().energy(execution);
  EXPECT_GT(energy.fracture, 0.0);
  EXPECT_LT(std::abs(energy.residual), 2e-4 * energy.fluid);
  return broke;
}

TEST(QuasiStatic, HowMuchBreaksDoesNotDependOnTheStep) {
  const std::size_t broke = broken_after_an_hour(3600.0);
  EXPECT_GT(broke, 0U);
  EXPECT_EQ(broken_after_an_hour(1200.0), broke);
}

TEST(QuasiStatic, AStepThatIsGivenUpLeavesNothingBehind) {
  Coupled coupled(test::notched(grid), confined());
  QuasiStatic scheme(coupled.model(), {1e-2, 1e-3});
  Execution execution;
  scheme.advance(600.0, execution);
  const std::string before = coupled.bits();
  const std::size_t open = coupled.water().cracks.broken_joints().size();
  std::size_t most = 0;
  scheme.listen([&] {
    most = std::max(most, coupled.water().cracks.broken_joints().size());
    return most > open;
  });
  EXPECT_TRUE(scheme.advance(3600.0, execution).broke.empty());
  EXPECT_TRUE(scheme.gave_up());
  EXPECT_GT(most, open);
  EXPECT_EQ(coupled.bits(), before);
  EXPECT_EQ(coupled.water().cracks.broken_joints().size(), open);
  EXPECT_EQ(coupled.water().state.time, 600.0);
  EXPECT_EQ(coupled.rock().model().motion.time, 600.0);
}

TEST(QuasiStatic, GivesTheSameBitsOnAnyNumberOfThreads) {
  std::string reference;
  for (const auto& [backend, threads] :
       {std::pair{Backend::serial, 1}, {Backend::host, 1}, {Backend::host, 2}}) {
    Coupled coupled(test::notched(grid), confined());
    QuasiStatic scheme(coupled.model(), {1e-1, 5e-2});
    Execution execution(backend, threads);
    scheme.advance(60.0, execution);
    if (reference.empty()) {
      reference = coupled.bits();
    }
    EXPECT_EQ(coupled.bits(), reference) << threads;
  }
}

TEST(QuasiStatic, AStepWithoutSolutionTellsWhatIsLacking) {
  Coupled coupled(test::notched({.columns = 2, .rows = 2}), pumped(test::strong()));
  // Forces so far out of balance leave no pressure settled.
  QuasiStatic scheme(coupled.model(), {1e-12, 0.5});
  Execution execution;
  try {
    scheme.advance(3600.0, execution);
    FAIL() << "it found a solution";
  } catch (const SolverError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("of the largest away, allowed: 1e-12 (time.tolerance)"), std::string::npos)
        << said;
    EXPECT_NE(said.find("allowed: 0.5 (time.balance_tolerance)"), std::string::npos) << said;
    EXPECT_EQ(said.find("breaks through"), std::string::npos) << said;
  }
}

/// What consolidates by itself has nowhere to flow: undrained pressure, as the explicit scheme has.
TEST(QuasiStatic, LoadedRockTakesUpPressureUndrained) {
  Coupled coupled(test::make_grid(grid), test::squeezed());
  QuasiStatic scheme(coupled.model(), exact());
  Execution execution;
  scheme.advance(100.0, execution);
  for (const Index node : coupled.water().pore_nodes.nodes(coupled.water().mesh)) {
    ASSERT_NEAR(coupled.water().state.pressure[at(node)], test::squeezed_pressure,
                2e-3 * test::squeezed_pressure);
  }
  EXPECT_LT(coupled.mass_error(), 1e-14);
}

}  // namespace
}  // namespace percolith::coupling
