// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/report.hpp"

#include <filesystem>

namespace percolith::io {

/// Writes the matrix at `time` (s) as triangles (`.vtu`): pressure_Pa, head_m (with gravity) and
/// saturation at points, darcy_flux_m_per_s and region in triangles. Throws FileError.
void write_matrix(const std::filesystem::path& path, double time,
                  const simulation::MatrixFrame& matrix);

/// Writes the cracks at `time` (s) as line segments (`.vtu`): pressure_Pa, head_m (with gravity)
/// and saturation at points, aperture_m, flux_m2_per_s and fracture in segments. Throws FileError.
void write_cracks(const std::filesystem::path& path, double time,
                  const simulation::CrackFrame& cracks);

}  // namespace percolith::io
