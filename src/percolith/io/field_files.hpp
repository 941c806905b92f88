// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/report.hpp"

#include <filesystem>

namespace percolith::io {

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
