// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/io/vtu.hpp"
#include "percolith/simulation/report.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace percolith::io {

/// The matrix and the cracks of a frame at `time` (s) under the names that files have. The arrays
/// are those of the frame and of `connectivity`, which is filled; they must outlive the grid.
[[nodiscard]] UnstructuredGrid matrix_grid(double time, const simulation::MatrixFrame& matrix,
                                           std::vector<std::int32_t>& connectivity);
[[nodiscard]] UnstructuredGrid crack_grid(double time, const simulation::CrackFrame& cracks,
                                          std::vector<std::int32_t>& connectivity);

/// Writes the matrix at `time` (s) as triangles (`.vtu`): pressure_Pa, head_m and saturation at
/// points, darcy_flux_m_per_s in triangles, each where the frame has it; region in triangles; then
/// the further fields of the frame under their own names. Throws FileError.
void write_matrix(const std::filesystem::path& path, double time,
                  const simulation::MatrixFrame& matrix);

/// Writes the cracks at `time` (s) as line segments (`.vtu`): pressure_Pa, head_m and saturation
/// at points, aperture_m and flux_m2_per_s in segments, each where the frame has it; fracture (-1
/// where a segment belongs to none) in segments; then the further fields of the frame. Throws
/// FileError.
void write_cracks(const std::filesystem::path& path, double time,
                  const simulation::CrackFrame& cracks);

}  // namespace percolith::io
