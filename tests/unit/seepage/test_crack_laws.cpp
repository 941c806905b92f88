// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/crack.hpp"

#include <gtest/gtest.h>

#include "unit/support/flow_model.hpp"

namespace percolith::seepage {
namespace {

using material::Fracture;

TEST(HydraulicAperture, IsClampedOnBothSidesAndTheStorageApertureBelowOnly) {
  const Fracture f{.initial_aperture = 1e-4,
                   .minimum_aperture = 2e-5,
                   .maximum_aperture = 3e-4,
                   .transmissivity = {}};
  EXPECT_DOUBLE_EQ(hydraulic_aperture(f, 5e-5), 1.5e-4);
  EXPECT_EQ(hydraulic_aperture(f, -9e-5), 2e-5);
  EXPECT_EQ(hydraulic_aperture(f, 1.0), 3e-4);
  EXPECT_DOUBLE_EQ(storage_aperture(f, 5e-5), 1.5e-4);
  EXPECT_EQ(storage_aperture(f, -9e-5), 2e-5);
  EXPECT_DOUBLE_EQ(storage_aperture(f, 1.0), 1.0001);
}

TEST(CrackConductance, FollowsTheCubicLawUnlessTransmissivityIsGiven) {
  const Fracture cubic{.initial_aperture = 1e-4, .transmissivity = {}};
  // a^3/(12 mu L)
  EXPECT_DOUBLE_EQ(crack_conductance(cubic, 1e-4, 0.5, 1e-3), 1e-12 / (12.0 * 1e-3 * 0.5));
  EXPECT_DOUBLE_EQ(crack_conductance(cubic, 2e-4, 0.5, 1e-3),
                   8.0 * crack_conductance(cubic, 1e-4, 0.5, 1e-3));
  const Fracture given{.initial_aperture = 1e-4, .transmissivity = 3e-12};
  EXPECT_DOUBLE_EQ(crack_conductance(given, 7e-4, 0.5, 1e-3), 3e-12 / (1e-3 * 0.5));
}

TEST(ExchangeConductance, IsHalfTheLengthForEachCorner) {
  const Fracture f{.transmissivity = {}, .exchange = 4e-9};
  EXPECT_DOUBLE_EQ(exchange_conductance(f, 0.5), 1e-9);
  EXPECT_EQ(exchange_conductance({}, 0.5), test::infinity);
}

TEST(CrackProperties, OfBrokenJointsComeFromTheirGroup) {
  const test::Grid grid{.columns = 4, .rows = 4};
  auto file = test::make_grid(grid);
  test::add_column_curve(grid, file, "first", 2, 0, 3);
  test::add_row_curve(grid, file, "second", 2, 2, 4);
  test::FlowOptions options;
  options.fracture = {
      {.initial_aperture = 1e-4, .transmissivity = {}, .exchange = 1e-9},
      {.initial_aperture = 3e-4, .maximum_aperture = 2e-4, .transmissivity = {}, .exchange = 5e-9}};
  Model model = test::make_flow(file, options);
  test::break_curve(model, "first", 0);
  test::break_curve(model, "second", 1);
  const auto& crack = model.crack;
  const Index j = model.mesh.curves.at("second").joints.front();
  EXPECT_EQ(crack.group[test::at(j)], 1);
  EXPECT_EQ(crack.aperture[test::at(j)], 2e-4);
  EXPECT_DOUBLE_EQ(crack.conductance[test::at(j)], 8e-12 / (12.0 * 1e-3 * 0.25));
  EXPECT_DOUBLE_EQ(crack.exchange[test::at(j)], 0.5 * 5e-9 * 0.25);
  // Two halves of the first and one half of the second meet in the middle; volumes are not clamped.
  EXPECT_DOUBLE_EQ(crack.void_volume[test::at(test::vertex_at(model.mesh, {0.5, 0.5}))],
                   0.5 * 0.25 * (2.0 * 1e-4 + 3e-4));
  EXPECT_EQ(crack.void_volume[test::at(test::vertex_at(model.mesh, {0.25, 0.25}))], 0.0);
}

}  // namespace
}  // namespace percolith::seepage
