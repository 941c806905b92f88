// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/coupling/quasi_static.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/support/coupled_model.hpp"

namespace percolith::coupling {
namespace {

using test::at;
using test::Coupled;
using test::CoupledOptions;

constexpr test::Grid grid{.columns = 6, .rows = 6, .jitter = 0.15, .mixed_diagonals = true};

mesh::GmshMesh notched() {
  mesh::GmshMesh file = test::make_grid(grid);
  test::add_row_curve(grid, file, "crack", 3, 0, 3);
  return file;
}

/// Holds the lower and the upper side.
mechanics::SupportSet held(mechanics::Model& rock) {
  std::vector<mechanics::Held> corners;
  for (const mesh::BoundaryEdge& edge : rock.mesh.boundary) {
    const Point a = rock.mesh.vertex[at(edge.vertex[0])];
    const Point b = rock.mesh.vertex[at(edge.vertex[1])];
    if (a.y == b.y) {
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

QuasiStaticOptions exact(Coupled& coupled) {
  return {1e-3, 1e-4, 0.9 * coupled.limit().rock()};
}

/// Fluid and room agree at the pressure that was found, which the contents do not show: V (1 + p/K)
/// is what the crack holds.
TEST(QuasiStatic, FindsThePressureThatHoldsTheCrackOpen) {
  Coupled coupled(notched(), pumped(test::strong()));
  QuasiStatic scheme(coupled.model(), exact(coupled));
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

TEST(QuasiStatic, RockThatBreaksTakesTheFluidIn) {
  Coupled coupled(notched(), pumped(test::joint_kind(1e6, 3e6, 20.0, 60.0), 1e-8));
  QuasiStatic scheme(coupled.model(), {1e-2, 1e-3, 0.9 * coupled.limit().rock()});
  Execution execution;
  std::size_t broke = 0;
  for (int hour = 0; hour < 60 && broke == 0; ++hour) {
    broke += scheme.advance(3600.0, execution).broke.size();
  }
  EXPECT_GT(broke, 0U);
  EXPECT_GT(coupled.water().cracks.broken_joints().size(), 3U);
  EXPECT_LT(coupled.mass_error(), 1e-13);
}

/// What consolidates by itself has nowhere to flow: undrained pressure, as the explicit scheme has.
TEST(QuasiStatic, LoadedRockTakesUpPressureUndrained) {
  Coupled coupled(test::make_grid(grid), test::squeezed());
  QuasiStatic scheme(coupled.model(), exact(coupled));
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
