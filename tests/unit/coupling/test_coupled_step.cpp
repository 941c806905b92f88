// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/coupling/drainage.hpp"
#include "percolith/coupling/fluid_stiffness.hpp"
#include "percolith/mechanics/build.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

#include "unit/support/coupled_model.hpp"

namespace percolith::coupling {
namespace {

using test::at;
using test::Coupled;
using test::CoupledOptions;

constexpr test::Grid grid{.columns = 12, .rows = 12, .jitter = 0.2, .mixed_diagonals = true};

/// Water pressed so fast into the crack that the rock breaks.
CoupledOptions injected() {
  CoupledOptions options;
  options.solid.kind = test::joint_kind(2e6, 6e6, 20.0, 60.0);
  options.solid.curves = {{"crack", mechanics::JointState::closed}};
  options.flow.rock.biot_modulus = 10e9;
  options.flow.fracture[0].maximum_aperture = 2e-4;
  options.prepare_water = [](seepage::Model& water) {
    test::break_curve(water, "crack");
    test::inject_crack(water, "source.left", Schedule::constant(0.1), {0.0, 0.5});
  };
  return options;
}

struct Variant {
  JointStress joint_stress;
  FluidEnters fluid_enters;
  seepage::PoreJoints pore_joints;
};

class Injection : public testing::TestWithParam<Variant> {};

TEST_P(Injection, BreaksTheRockAndLosesNeitherFluidNorEnergy) {
  CoupledOptions options = injected();
  options.joint_stress = GetParam().joint_stress;
  options.fluid_enters = GetParam().fluid_enters;
  options.flow.joints = GetParam().pore_joints;
  Coupled coupled(test::notched(grid), options);
  const auto open_at_start = coupled.water().cracks.broken_joints().size();
  EXPECT_GT(coupled.advance(3000), 3);
  EXPECT_GT(coupled.water().cracks.broken_joints().size(), open_at_start + 3);
  EXPECT_GT(coupled.rock().energy(Execution()).fluid, 1.0);
  EXPECT_LT(coupled.mass_error(), 1e-13);
  EXPECT_LT(coupled.energy_error(), 1e-2);
}

INSTANTIATE_TEST_SUITE_P(
    Variants, Injection,
    testing::Values(
        Variant{JointStress::effective, FluidEnters::broken, seepage::PoreJoints::tied},
        Variant{JointStress::total, FluidEnters::broken, seepage::PoreJoints::tied},
        Variant{JointStress::effective, FluidEnters::softening, seepage::PoreJoints::tied},
        Variant{JointStress::effective, FluidEnters::broken, seepage::PoreJoints::finite}));

TEST(CoupledStep, GivesTheSameBitsOnAnyNumberOfThreads) {
  std::string reference;
  for (const auto& [backend, threads] :
       {std::pair{Backend::serial, 1}, {Backend::host, 1}, {Backend::host, 2}}) {
    Coupled coupled(test::notched(grid), injected());
    Execution execution(backend, threads);
    coupled.advance(800, execution);
    if (reference.empty()) {
      reference = coupled.bits();
    }
    EXPECT_EQ(coupled.bits(), reference) << threads;
  }
}

/// A crack that opens lets the fluid lag behind: its new room is empty at first.
TEST(CoupledStep, FluidLagsBehindTheTip) {
  CoupledOptions options = injected();
  options.flow.fluid.viscosity = 1.0;
  Coupled coupled(test::notched(grid), options);
  coupled.advance(3000);
  double least = 1.0;
  for (const Index v : coupled.water().cracks.open_nodes()) {
    least = std::min(least, coupled.water().state.crack_saturation[at(v)]);
  }
  EXPECT_LT(least, 0.999);
}

/// Rock and water under their weight, held by the stress outside.
CoupledOptions at_rest(JointStress stress, mechanics::JointState joints) {
  CoupledOptions options = injected();
  options.joint_stress = stress;
  options.solid.joints = joints;
  options.solid.gravity = 9.81;
  options.flow.gravity = 9.81;
  const double weight = 9.81 * options.solid.rock.density;
  const auto total = [weight](const Point& p) {
    return Tensor{0.6 * weight * (p.y - 100.0), weight * (p.y - 100.0), 0.0};
  };
  options.prepare_water = [](seepage::Model& water) {
    test::break_curve(water, "crack");
    const auto hydrostatic = [](const Point& p) {
      return seepage::FluidState<double>{9810.0 * (100.0 - p.y), 1.0};
    };
    seepage::set_pores(water, hydrostatic);
    seepage::set_cracks(water, hydrostatic);
  };
  options.prepare_rock = [total](mechanics::Model& rock) {
    mechanics::set_initial_stress(rock, total);
  };
  options.loads = [total](const mechanics::Model& rock) {
    mechanics::LoadList loads;
    for (const mesh::BoundaryEdge& edge : rock.mesh.boundary) {
      const Point a = rock.mesh.vertex[at(edge.vertex[0])];
      const Point b = rock.mesh.vertex[at(edge.vertex[1])];
      const Point normal = clockwise(b - a);
      const std::array<Point, 2> end{total(a) * normal, total(b) * normal};
      for (std::size_t i = 0; i < 2; ++i) {
        loads.constant.push_back({edge.corner[i], (1.0 / 3.0) * end[i] + (1.0 / 6.0) * end[1 - i]});
      }
    }
    return loads;
  };
  return options;
}

class AtRest : public testing::TestWithParam<std::tuple<JointStress, mechanics::JointState>> {};

/// In-situ stress is total stress, whatever the fluid in the rock: nothing moves.
TEST_P(AtRest, StartsInEquilibriumWithTheFluidInPlace) {
  Coupled coupled(test::notched(grid), at_rest(std::get<0>(GetParam()), std::get<1>(GetParam())));
  coupled.advance(300);
  const auto balance = coupled.rock().energy(Execution());
  // Round-off of stresses of megapascals alone.
  EXPECT_LT(balance.kinetic, 1e-18);
  EXPECT_LT(std::abs(balance.fluid), 1e-9);
  EXPECT_LT(coupled.mass_error(), 1e-15);
}

/// What is taken out keeps giving its forces, those of its fluid among them, until they fade.
TEST_P(AtRest, StaysSoWhileAnExcavationKeepsItsSupport) {
  Coupled coupled(test::notched(grid), at_rest(std::get<0>(GetParam()), std::get<1>(GetParam())));
  std::vector<Index> opening;
  for (Index t = 0; t < coupled.water().mesh.triangles(); ++t) {
    const Point p = test::centroid(coupled.water().mesh, t);
    if (std::hypot(p.x - 0.4, p.y - 0.5) < 0.2) {
      opening.push_back(t);
    }
  }
  coupled.rock().take_out(opening, 1e9);
  coupled.advance(300);
  EXPECT_LT(coupled.rock().energy(Execution()).kinetic, 1e-14);
}

INSTANTIATE_TEST_SUITE_P(
    Rocks, AtRest,
    testing::Combine(testing::Values(JointStress::effective, JointStress::total),
                     testing::Values(mechanics::JointState::bonded, mechanics::JointState::tied)));

/// Pressure inside pushes on nothing but the rock itself.
TEST(CoupledStep, MomentumStaysZero) {
  Coupled coupled(test::notched(grid), injected());
  coupled.advance(1500);
  const mechanics::Model& rock = coupled.rock().model();
  Point momentum{};
  double size = 0.0;
  test::for_each_corner(rock.mesh, [&](Index t, Index c) {
    const double mass = 1.0 / rock.triangles.inverse_mass[at(t)];
    const Point p = mass * Point{rock.motion.vx[at(c)], rock.motion.vy[at(c)]};
    momentum = momentum + p;
    size += std::hypot(p.x, p.y);
  });
  EXPECT_LT(std::hypot(momentum.x, momentum.y), 1e-12 * size);
}

TEST(CoupledStep, UndrainedRockTakesUpPressure) {
  Coupled coupled(test::make_grid(grid), test::squeezed());
  coupled.advance(4000);
  for (const Index node : coupled.water().pore_nodes.nodes(coupled.water().mesh)) {
    EXPECT_NEAR(coupled.water().state.pressure[at(node)], test::squeezed_pressure,
                1e-3 * test::squeezed_pressure);
  }
}

TEST(Drainage, LetsTheFluidOutOfWhatIsTakenOut) {
  CoupledOptions options = injected();
  options.prepare_water = [](seepage::Model& water) {
    test::break_curve(water, "crack");
    const auto full = [](const Point&) { return seepage::FluidState<double>{1e6, 1.0}; };
    seepage::set_pores(water, full);
    seepage::set_cracks(water, full);
  };
  Coupled coupled(test::notched(grid), options);
  const Index number = add_drainage(coupled.water(), "excavation.opening", 2e5);
  const std::vector<Index> opening{0, 1, 2};
  coupled.rock().take_out(opening, 1.0);
  drain(coupled.model(), opening, number);
  coupled.step().network_changed();
  coupled.advance(5);
  for (const Index t : opening) {
    for (Index k = 0; k < 3; ++k) {
      EXPECT_NEAR(coupled.water().state.pressure[at(mesh::corner_of(t, k))], 2e5, 1.0);
    }
  }
  EXPECT_LT(coupled.water().let_in[at(number)].total(), 0.0);
  EXPECT_LT(coupled.mass_error(), 1e-14);
}

/// Rock under a total stress of -1 MPa, as its pores have it and everything round it.
CoupledOptions afloat() {
  constexpr double pressure = 1e6;
  CoupledOptions options = test::squeezed();
  options.solid.joints = mechanics::JointState::bonded;
  options.prepare_rock = [](mechanics::Model& rock) {
    mechanics::set_initial_stress(rock, [](Point) { return Tensor{-pressure, -pressure, 0.0}; });
  };
  options.prepare_water = [](seepage::Model& water) {
    seepage::set_pores(water, [](const Point&) {
      return seepage::FluidState<double>{pressure, 1.0};
    });
  };
  options.loads = [](const mechanics::Model& rock) {
    mechanics::LoadList loads;
    std::vector<Index> edges(rock.mesh.boundary.size());
    std::iota(edges.begin(), edges.end(), 0);
    loads.pressure.push_back({edges, Schedule::constant(pressure)});
    return loads;
  };
  return options;
}

/// Largest displacement of rock that is left, m, once an opening filled with fluid of that
/// pressure (Pa) has been made.
double moved_by_opening(double pressure, mechanics::JointState joints) {
  CoupledOptions options = afloat();
  options.solid.joints = joints;
  Coupled coupled(test::make_grid(grid), options);
  std::vector<Index> opening;
  for (Index t = 0; t < coupled.water().mesh.triangles(); ++t) {
    const Point c = test::centroid(coupled.water().mesh, t);
    if (std::max(std::abs(c.x - 0.5), std::abs(c.y - 0.5)) < 0.2) {
      opening.push_back(t);
    }
  }
  const Index number = add_drainage(coupled.water(), "excavation.opening", 1e6);
  coupled.advance(1);
  coupled.rock().take_out(opening, 1e-3, pressure);
  drain(coupled.model(), opening, number);
  coupled.step().network_changed();
  while (coupled.water().state.time < 1.5e-3) {
    coupled.advance(1);
  }
  if (pressure != 1e6) {  // what is at rest has no energy to compare with
    EXPECT_LT(coupled.energy_error(), 1e-2);
  }
  double most = 0.0;
  test::for_each_corner(coupled.rock().model().mesh, [&](Index, Index c) {
    most = std::max(most, test::distance(test::displacement(coupled.rock().model(), c), {}));
  });
  return most;
}

TEST(Drainage, FluidInAnOpeningTakesThePlaceOfTheRock) {
  for (const auto joints : {mechanics::JointState::bonded, mechanics::JointState::tied}) {
    const double bare = moved_by_opening(0.0, joints);
    EXPECT_GT(bare, 1e-5);
    EXPECT_LT(moved_by_opening(1e6, joints), 1e-6 * bare);
    EXPECT_NEAR(moved_by_opening(2e6, joints), bare, 0.05 * bare) << "the other way";
  }
}

/// The forces on all faces round a crack node where three joints meet, once one corner has moved.
TEST(StepLimit, CountsAllFacesThatACornerPressesThroughTheFluid) {
  constexpr double bulk_modulus = 2.2e9;
  constexpr double aperture = 3e-5;
  const std::vector<double> lengths{0.02, 0.05, 0.03};
  double volume = 0.0;
  for (const double length : lengths) {
    volume += 0.5 * length * aperture;
  }
  constexpr double moved = 1e-9;
  for (const double length : lengths) {
    const double pressure = bulk_modulus * (0.5 * length * moved) / volume;
    double force = 0.0;
    for (const double other : lengths) {
      force += 2.0 * (0.5 * other * pressure);  // on both its faces
    }
    EXPECT_NEAR(fluid_stiffness(length, 0.1, bulk_modulus, volume), force / moved,
                1e-12 * force / moved);
    EXPECT_NEAR(fluid_stiffness(length, 2.0 * length, bulk_modulus, length * aperture),
                bulk_modulus * length / aperture, 1e-12 * bulk_modulus * length / aperture)
        << "in a straight crack of equal joints";
  }
}

/// A step twice the limit is unstable where the fluid rules it, one just below is not.
TEST(StepLimit, CountsTheFluidInThinCracks) {
  CoupledOptions options = injected();
  options.flow.fracture[0].initial_aperture = 1e-6;
  Coupled coupled(test::notched(grid), options);
  const double limit = coupled.limit().motion(coupled.model());
  EXPECT_LT(limit, coupled.limit().rock());
  EXPECT_LT(limit, 0.5 * coupled.limit().rock());
  Execution execution;
  for (int i = 0; i < 400; ++i) {
    coupled.step().advance(0.95 * coupled.limit().motion(coupled.model()), execution);
  }
  EXPECT_LT(coupled.energy_error(), 1e-2);
}

/// The notch is as thin as new cracks are, but not along the longest edges: what is foreseen for
/// all of them is shorter than its limit, not by much, and goes with the root of the aperture.
TEST(StepLimit, ForeseesThinNewCracks) {
  CoupledOptions options = injected();
  options.solid.joints = mechanics::JointState::bonded;
  options.flow.fracture[0].initial_aperture = 1e-6;
  Coupled coupled(test::notched(grid), options);
  const double foreseen = coupled.limit().in_new_cracks(coupled.model());
  const double now = coupled.limit().motion(coupled.model());
  EXPECT_LT(foreseen, now);
  EXPECT_GT(foreseen, 0.5 * now);
  options.flow.fracture[0].initial_aperture = 4e-6;
  Coupled wider(test::notched(grid), options);
  EXPECT_NEAR(wider.limit().in_new_cracks(wider.model()), 2.0 * foreseen, 0.2 * foreseen);
  options.solid.joints = mechanics::JointState::tied;
  Coupled tied(test::notched(grid), options);
  EXPECT_EQ(tied.limit().in_new_cracks(tied.model()), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace percolith::coupling
