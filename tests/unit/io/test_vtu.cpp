// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/compressed_blocks.hpp"
#include "percolith/io/field_files.hpp"
#include "percolith/io/vtu.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "unit/io/frames.hpp"
#include "unit/io/temporary_folder.hpp"
#include "unit/io/vtu_decoder.hpp"

namespace percolith {
namespace {

using Reals = std::vector<double>;
using Integers = std::vector<std::int32_t>;

TEST(MatrixFile, HoldsEveryValueToTheLastBit) {
  const test::TemporaryFolder folder;
  const simulation::Frame frame = test::cracked_square(12.5);
  io::write_matrix(folder / "m.vtu", frame.time, frame.matrix);
  const test::VtuDecoder file(test::read_text(folder / "m.vtu"));
  EXPECT_EQ(file.attribute("<VTKFile", "type"), "UnstructuredGrid");
  EXPECT_EQ(file.attribute("<VTKFile", "header_type"), "UInt64");
  EXPECT_EQ(file.attribute("<VTKFile", "compressor"), "vtkZLibDataCompressor");
  EXPECT_EQ(file.attribute("<Piece", "NumberOfPoints"), "6");
  EXPECT_EQ(file.attribute("<Piece", "NumberOfCells"), "2");
  EXPECT_EQ(file.array<double>("Float64", "TimeValue"), Reals{12.5});
  EXPECT_EQ(file.array<double>("Float64", "Points"),
            (Reals{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0}));
  EXPECT_EQ(file.array<std::int32_t>("Int32", "connectivity"), (Integers{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(file.array<std::int32_t>("Int32", "offsets"), (Integers{3, 6}));
  EXPECT_EQ(file.array<std::uint8_t>("UInt8", "types"), (std::vector<std::uint8_t>{5, 5}));
  EXPECT_EQ(file.array<double>("Float64", "pressure_Pa"), frame.matrix.pressure);
  EXPECT_EQ(file.array<double>("Float64", "head_m"), frame.matrix.head);
  EXPECT_EQ(file.array<double>("Float64", "saturation"), frame.matrix.saturation);
  EXPECT_EQ(file.array<double>("Float64", "darcy_flux_m_per_s"),
            (Reals{1e-6, -2e-6, 0, 3e-6, 4e-6, 0}));
  EXPECT_EQ(file.array<std::int32_t>("Int32", "region"), (Integers{0, 1}));
  EXPECT_TRUE(file.has("PointData", "pressure_Pa"));
  EXPECT_TRUE(file.has("CellData", "darcy_flux_m_per_s"));
}

TEST(MatrixFile, LeavesHeadOutWithoutGravity) {
  const test::TemporaryFolder folder;
  simulation::Frame frame = test::cracked_square(0);
  frame.matrix.head.clear();
  io::write_matrix(folder / "m.vtu", frame.time, frame.matrix);
  EXPECT_FALSE(test::VtuDecoder(test::read_text(folder / "m.vtu")).has("PointData", "head_m"));
}

TEST(CrackFile, HoldsLinesWithTheirQuantities) {
  const test::TemporaryFolder folder;
  const simulation::Frame frame = test::cracked_square(0.1);
  io::write_cracks(folder / "c.vtu", frame.time, frame.cracks);
  const test::VtuDecoder file(test::read_text(folder / "c.vtu"));
  EXPECT_EQ(file.array<std::uint8_t>("UInt8", "types"), std::vector<std::uint8_t>{3});
  EXPECT_EQ(file.array<std::int32_t>("Int32", "connectivity"), (Integers{0, 1}));
  EXPECT_EQ(file.array<std::int32_t>("Int32", "offsets"), Integers{2});
  EXPECT_EQ(file.array<double>("Float64", "pressure_Pa"), frame.cracks.pressure);
  EXPECT_EQ(file.array<double>("Float64", "head_m"), frame.cracks.head);
  EXPECT_EQ(file.array<double>("Float64", "saturation"), frame.cracks.saturation);
  EXPECT_EQ(file.array<double>("Float64", "aperture_m"), frame.cracks.aperture);
  EXPECT_EQ(file.array<double>("Float64", "flux_m2_per_s"), frame.cracks.flux);
  EXPECT_EQ(file.array<std::int32_t>("Int32", "fracture"), Integers{3});
}

TEST(MatrixFile, HoldsTheFieldsOfMechanicsAndNoneOfFlow) {
  const test::TemporaryFolder folder;
  const simulation::Frame frame = test::broken_square(1);
  io::write_matrix(folder / "m.vtu", frame.time, frame.matrix);
  const test::VtuDecoder file(test::read_text(folder / "m.vtu"));
  EXPECT_TRUE(file.has("PointData", "displacement_m"));
  EXPECT_EQ(file.array<double>("Float64", "displacement_m"),
            (Reals{1e-3, -2e-3, 0, 1e-3, -2e-3, 0, 1e-3, -2e-3, 0, 1e-3, -2e-3, 0, 1e-3, -2e-3, 0,
                   1e-3, -2e-3, 0}));
  EXPECT_TRUE(file.has("CellData", "damage"));
  EXPECT_EQ(file.array<double>("Float64", "damage"), (Reals{0.25, 1.0 / 3}));
  EXPECT_EQ(file.array<std::int32_t>("Int32", "fragment"), (Integers{0, 1}));
  EXPECT_EQ(file.array<double>("Float64", "principal_direction"), (Reals{1, 0, 0, 0.6, 0.8, 0}));
  EXPECT_EQ(file.array<std::int32_t>("Int32", "region"), (Integers{0, 1}));
  for (const char* name : {"pressure_Pa", "head_m", "saturation"}) {
    EXPECT_FALSE(file.has("PointData", name)) << name;
  }
  EXPECT_FALSE(file.has("CellData", "darcy_flux_m_per_s"));
}

TEST(MatrixFile, RefusesAFieldOfWrongLength) {
  const test::TemporaryFolder folder;
  simulation::Frame frame = test::broken_square(1);
  frame.matrix.cell_fields = {{"damage", std::vector<double>(6)}};
  try {
    io::write_matrix(folder / "m.vtu", frame.time, frame.matrix);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "array damage holds 6 values where 2 belong");
  }
}

TEST(CrackFile, HoldsTheFieldsOfMechanicsAndNoneOfFlow) {
  const test::TemporaryFolder folder;
  const simulation::Frame frame = test::broken_square(1);
  io::write_cracks(folder / "c.vtu", frame.time, frame.cracks);
  const test::VtuDecoder file(test::read_text(folder / "c.vtu"));
  EXPECT_EQ(file.array<double>("Float64", "opening_m"), Reals{2e-5});
  EXPECT_EQ(file.array<std::int32_t>("Int32", "mode"), Integers{-1});
  EXPECT_EQ(file.array<std::int32_t>("Int32", "fracture"), Integers{-1});
  EXPECT_FALSE(file.has("PointData", "pressure_Pa"));
  EXPECT_FALSE(file.has("PointData", "saturation"));
  EXPECT_FALSE(file.has("CellData", "aperture_m"));
  EXPECT_FALSE(file.has("CellData", "flux_m2_per_s"));
}

TEST(CrackFile, MayBeEmpty) {
  const test::TemporaryFolder folder;
  io::write_cracks(folder / "c.vtu", 0.0, {});
  const test::VtuDecoder file(test::read_text(folder / "c.vtu"));
  EXPECT_EQ(file.attribute("<Piece", "NumberOfCells"), "0");
  EXPECT_TRUE(file.array<std::int32_t>("Int32", "fracture").empty());
}

// A line mesh with `count` points whose pressures need several blocks.
void expect_round_trip(std::size_t count) {
  const test::TemporaryFolder folder;
  std::vector<Point> points(count);
  std::vector<double> values(count);
  std::iota(values.begin(), values.end(), 0.25);
  io::UnstructuredGrid grid;
  grid.shape = io::CellShape::line;
  grid.points = points;
  grid.point_data = {{"a \"<&> b", std::span<const double>(values)}};
  io::write_vtu(folder / "g.vtu", grid);
  const test::VtuDecoder file(test::read_text(folder / "g.vtu"));
  EXPECT_EQ(file.array<double>("Float64", "a &quot;&lt;&amp;&gt; b"), values);
}

TEST(Vtu, SplitsLargeArraysIntoBlocks) {
  const std::size_t per_block = io::block_size / sizeof(double);
  expect_round_trip(per_block - 1);
  expect_round_trip(per_block);
  expect_round_trip(per_block + 1);
  expect_round_trip(2 * per_block);
}

TEST(Vtu, RefusesArraysOfWrongLength) {
  const test::TemporaryFolder folder;
  const std::vector<Point> points(3);
  const std::vector<double> values(2);
  io::UnstructuredGrid grid;
  grid.points = points;
  grid.point_data = {{"p", std::span<const double>(values)}};
  try {
    io::write_vtu(folder / "g.vtu", grid);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "array p holds 2 values where 3 belong");
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "g.vtu"));
}

}  // namespace
}  // namespace percolith
