// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/vec2.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace percolith::io {

/// A named quantity with one value a point or a cell; a `Point` becomes a vector with z = 0.
struct DataArray {
  std::string name;
  std::variant<std::span<const double>, std::span<const std::int32_t>, std::span<const Point>>
      values;
};

/// Shapes of cells with their number in VTK.
enum class CellShape : std::uint8_t { line = 3, triangle = 5 };

/// A mesh of one shape of cell with its quantities.
struct UnstructuredGrid {
  double time = 0.0;  ///< s
  CellShape shape = CellShape::triangle;
  std::span<const Point> points;               ///< m
  std::span<const std::int32_t> connectivity;  ///< two or three point indices a cell
  std::vector<DataArray> point_data;           ///< as many values as points
  std::vector<DataArray> cell_data;            ///< as many values as cells
};

/// Writes `grid` as a VTK XML unstructured grid (`.vtu`): values in binary, appended, compressed
/// by zlib, Float64 and Int32, headers UInt64; the time stands in the field data as `TimeValue`.
/// The file appears under its name only when complete. Throws FileError; throws
/// std::invalid_argument where an array has not one value a point or a cell.
void write_vtu(const std::filesystem::path& path, const UnstructuredGrid& grid);

}  // namespace percolith::io
